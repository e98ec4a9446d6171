// The free spans of every line: f_{Y|X} of the paper's section 4.1, the bottom of its figure 1.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plan/plan.h"
#include "portable/chord.h"
#include "portable/distance.h"

namespace lacuna::reference {

class FreeSpans {
public:
    explicit FreeSpans(const Plan& plan);

    const std::vector<Span>& of_line(std::uint32_t line) const { return spans_[line]; }
    // The total length of each line's spans.
    std::span<const std::uint32_t> lengths() const { return lengths_; }
    // The rank-th free y of the line, counted from below. rank < lengths()[line].
    std::uint32_t y_at_rank(std::uint32_t line, std::uint32_t rank) const;
    bool is_free(std::uint32_t line, std::uint32_t y) const;
    // Cuts the sample's disk from every line that crosses it.
    void subtract_disk(Sample sample);

private:
    void subtract(std::uint32_t line, Span chord);

    const Plan& plan_;
    std::vector<std::vector<Span>> spans_;  // of each line: sorted, disjoint, none empty
    std::vector<std::uint32_t> lengths_;
};

// Visits the interval of all y' with |y' - y| < reach, cut to the domain: in one part or, if it
// wraps around a torus, in up to three.
template <typename Visit>
void for_each_window(const Plan& plan, std::uint32_t y, std::uint32_t reach, Visit visit) {
    for (std::uint32_t window = 0; reach != 0 && window < (plan.period_y == 0 ? 1 : 3); ++window) {
        const Span chord = {portable::window_begin(window, y, reach, plan.height),
                            portable::window_end(window, y, reach, plan.height)};
        if (chord.begin < chord.end) visit(chord);
    }
}

// Visits the chords of the sample's disk on a line at x or, with a margin, on the strip that
// reaches `margin` units to both sides of x.
template <typename Visit>
void for_each_chord(const Plan& plan, Sample sample, std::uint32_t x, std::uint32_t margin,
                    Visit visit) {
    const std::uint32_t dx = portable::axis_distance(sample.x, x, plan.period_x) + margin;
    for_each_window(plan, sample.y, portable::chord_reach(dx, plan.radius_squared), visit);
}

}  // namespace lacuna::reference
