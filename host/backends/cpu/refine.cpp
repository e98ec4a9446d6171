// refine: what all samples leave of the places, in boxes (docs/design.md, section 4, "exact").
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "backends/cpu/state.h"
#include "portable/chord.h"
#include "portable/distance.h"
#include "portable/fate.h"

namespace lacuna::cpu {
namespace {

// The samples near a box, in arrays of their own so that the arithmetic on them can be vectorised.
// The height is that of the image of the sample that is near: on a torus it may lie outside.
struct Near {
    // A box and a radius around it reach over at most 7 x 6 cells, and a torus has three images.
    static constexpr std::size_t kMost = 128;
    std::array<std::uint32_t, kMost> x;
    std::array<std::int64_t, kMost> y;
    std::size_t count = 0;
};

class Refinement {
public:
    Refinement(const State& state, std::uint32_t width) : state_(state), width_(width) {}

    // Appends what is left of a box as wide as the places were, cut to the new width.
    void cut(Box box, std::vector<Box>& left) {
        gather(box);
        for (std::uint32_t x = box.x; x < box.x + state_.place_width(); x += width_)
            cut_strip({x, box.begin, box.end}, left);
    }
    // The same of a span, which the rows of cells cut into boxes.
    void cut(std::uint32_t x, Span span, std::vector<Box>& left) {
        const std::uint32_t side = state_.plan.grid_side;
        while (span.begin < span.end) {
            const std::uint32_t row_end =
                std::min(span.end - span.begin, side - span.begin % side) + span.begin;
            cut({x, span.begin, row_end}, left);
            span.begin = row_end;
        }
    }

private:
    struct Chord {
        std::int64_t begin;
        std::int64_t end;
    };

    void gather(const Box& box) {
        const Plan& plan = state_.plan;
        const std::uint32_t r = plan.radius;
        const std::uint32_t x_end = box.x + state_.place_width();
        near_.count = 0;
        const bool is_inside = box.x >= r && box.begin >= r && r < plan.width && r < plan.height &&
                               x_end <= plan.width - r && box.end <= plan.height - r;
        if (is_inside)
            gather_inside(box, x_end);
        else
            gather_at_edges(box, x_end);
    }

    // Every cell is written, and kept or not: no branch.
    void gather_inside(const Box& box, std::uint32_t x_end) {
        const std::uint32_t r = state_.plan.radius;
        const std::uint32_t side = state_.plan.grid_side;
        const std::uint32_t last_column = (x_end - 1 + r) / side;
        const std::uint32_t first_row = (box.begin - r) / side;
        const std::uint32_t last_row = (box.end - 1 + r) / side;
        std::size_t count = 0;
        for (std::uint32_t i = (box.x - r) / side; i <= last_column; ++i) {
            const Sample* const cells = state_.grid->column(i);
            for (std::uint32_t row = first_row; row <= last_row; ++row) {
                near_.x[count] = cells[row].x;
                near_.y[count] = cells[row].y;
                count += cells[row].x != NO_SAMPLE;
            }
        }
        near_.count = count;
    }

    void gather_at_edges(const Box& box, std::uint32_t x_end) {
        const Plan& plan = state_.plan;
        const std::int64_t period = plan.period_y;
        const std::int64_t r = plan.radius;
        state_.grid->for_each_near(box.x, x_end, box.begin, box.end, [&](Sample sample) {
            for (std::int64_t image = period != 0 ? -1 : 0; image <= (period != 0 ? 1 : 0);
                 ++image) {
                const std::int64_t y = sample.y + image * period;
                if (y <= box.begin - r || y >= box.end - 1 + r) continue;
                near_.x[near_.count] = sample.x;
                near_.y[near_.count++] = y;
            }
        });
    }

    // Most strips are covered by one sample, and most samples near leave a strip alone: both show
    // in squared distances, and only what is left takes a square root.
    void cut_strip(const Box& strip, std::vector<Box>& left) {
        const Plan& plan = state_.plan;
        const std::uint32_t centre = strip.x + width_ / 2;
        const std::int64_t begin = strip.begin;
        const std::int64_t last = std::int64_t{strip.end} - 1;
        std::size_t touching = 0;
        bool covered = false;
        for (std::size_t i = 0; i < near_.count; ++i) {
            const std::uint64_t dx =
                portable::axis_distance(near_.x[i], centre, plan.period_x) + width_ / 2;
            const std::int64_t below = begin - near_.y[i];
            const std::int64_t above = near_.y[i] - last;
            const std::int64_t closest = std::max({below, above, std::int64_t{0}});
            const std::int64_t farthest = std::max(-below, -above);
            const std::uint64_t left_of_radius = plan.radius_squared - dx * dx;
            const bool reaches = dx < plan.radius;
            covered |= reaches & (square(farthest) < left_of_radius);
            touching_[touching] = static_cast<std::uint32_t>(i);
            touching += reaches && square(closest) < left_of_radius ? 1u : 0u;
        }
        if (covered) return;
        if (touching == 0) {
            left.push_back(strip);
            return;
        }
        find_chords(centre, touching);
        append_gaps(strip, touching, left);
    }

    // Of a distance below 2^32.
    static std::uint64_t square(std::int64_t a) {
        return static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(a);
    }

    // Sorted by where they begin: few, so by hand.
    void find_chords(std::uint32_t centre, std::size_t touching) {
        const Plan& plan = state_.plan;
        for (std::size_t i = 0; i < touching; ++i) {
            const std::uint32_t near = touching_[i];
            const std::uint32_t dx =
                portable::axis_distance(near_.x[near], centre, plan.period_x) + width_ / 2;
            const std::int64_t reach = portable::chord_reach(dx, plan.radius_squared);
            const Chord chord{near_.y[near] - reach + 1, near_.y[near] + reach};
            std::size_t to = i;
            for (; to > 0 && chord.begin < chords_[to - 1].begin; --to)
                chords_[to] = chords_[to - 1];
            chords_[to] = chord;
        }
    }

    void append_gaps(const Box& strip, std::size_t count, std::vector<Box>& left) const {
        std::int64_t free_from = strip.begin;
        const auto append = [&](std::int64_t end) {
            if (free_from < end)
                left.push_back({strip.x, static_cast<std::uint32_t>(free_from),
                                static_cast<std::uint32_t>(end)});
        };
        for (std::size_t i = 0; i < count; ++i) {
            append(std::min<std::int64_t>(chords_[i].begin, strip.end));
            free_from = std::max(free_from, chords_[i].end);
        }
        append(strip.end);
    }

    const State& state_;
    std::uint32_t width_;
    Near near_;
    std::array<std::uint32_t, Near::kMost> touching_;
    std::array<Chord, Near::kMost> chords_;
};

constexpr std::size_t kAhead = 4;  // boxes or spans; 4 to 8 are alike

void refine_boxes(const State& state, std::span<const Box> boxes, Refinement& refinement,
                  std::vector<Box>& left) {
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        const Box& later = boxes[std::min(k + kAhead, boxes.size() - 1)];
        state.grid->fetch_near(later.x, later.begin);
        refinement.cut(boxes[k], left);
    }
}

void refine_line(const State& state, std::uint32_t line, Refinement& refinement,
                 std::vector<Box>& left) {
    const std::uint32_t x = line * state.plan.strip_width;
    const std::span<const Span> spans = state.slot(line).first(state.span_counts[line]);
    for (std::size_t k = 0; k < spans.size(); ++k) {
        state.grid->fetch_near(x, spans[std::min(k + kAhead, spans.size() - 1)].begin);
        refinement.cut(x, spans[k], left);
    }
}

}  // namespace

void insert(State& state, std::uint32_t column) {
    for (std::uint32_t i = state.column_begins[column]; i < state.column_begins[column + 1]; ++i)
        if (state.fates[i] == FATE_ADMITTED)
            state.grid->insert({state.candidates[i].x, state.candidates[i].y});
}

void refine(State& state, std::uint32_t column, std::uint32_t width) {
    thread_local std::vector<Box> left;
    left.clear();
    Refinement refinement(state, width);
    if (state.has_boxes()) {
        refine_boxes(state, state.boxes[column], refinement, left);
    } else {
        for (std::uint32_t i = state.first_lines[column]; i < state.first_lines[column + 1]; ++i)
            refine_line(state, i, refinement, left);
    }
    state.boxes[column] = std::vector<Box>(left.begin(), left.end());
}

}  // namespace lacuna::cpu
