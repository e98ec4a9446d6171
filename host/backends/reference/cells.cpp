// Mode cells (section 4.2): a candidate is free where its lattice point is.
#include <algorithm>
#include <span>
#include <vector>

#include "backends/reference/free_space.h"
#include "base/polling.h"
#include "plan/first_free.h"
#include "portable/distance.h"
#include "portable/metric.h"
#include "portable/stretch.h"

namespace lacuna::reference {
namespace {

class Cells : public FreeSpace {
public:
    explicit Cells(const Plan& plan)
        : plan_(plan),
          is_free_(std::size_t{plan.lines} * plan.height),
          free_lengths_(first_free_lengths(plan)),
          widest_(*std::max_element(plan.cells().radii->radii.begin(),
                                    plan.cells().radii->radii.end())) {
        for (std::uint32_t x = 0; x < plan.lines; ++x) {
            ask_after(plan.height);
            for (const Span span : first_spans(plan, x))
                for (std::uint32_t y = span.begin; y < span.end; ++y)
                    is_free_[index_of(x, y)] = true;
        }
    }

    std::span<const std::uint32_t> free_lengths() const override { return free_lengths_; }
    std::uint32_t bin_width() const override { return 1; }
    Sample at(std::uint32_t line, std::uint32_t rank, std::uint32_t) const override {
        std::uint32_t y = 0;
        while (!is_free_[index_of(line, y)] || rank-- > 0) ++y;
        return {line, y};
    }
    bool is_free(Sample candidate) const override {
        return is_free_[index_of(candidate.x, candidate.y)];
    }

    // Loops over all lattice points that may be near enough, and blocks those that fail the two-way
    // check. With mean and max these may be farther away than the sample's radius.
    void add(Sample sample) override {
        const std::uint32_t radius =
            plan_.cells().metric == Metric::min ? radius_at(sample) : widest_;
        const std::uint32_t reach = radius / 256 + 1;  // in lattice steps
        for_each_within(sample.x, reach, plan_.lines, plan_.period_x, [&](std::uint32_t x) {
            ask_after(std::min(2 * reach + 1, plan_.height));
            for_each_within(sample.y, reach, plan_.height, plan_.period_y, [&](std::uint32_t y) {
                if (!is_free_[index_of(x, y)] || !conflict(sample, {x, y})) return;
                is_free_[index_of(x, y)] = false;
                --free_lengths_[x];
            });
        });
    }

private:
    std::size_t index_of(std::uint32_t x, std::uint32_t y) const {
        return std::size_t{x} * plan_.height + y;
    }
    std::uint32_t radius_at(Sample at) const {
        return plan_.cells().radii->radii[plan_.cells().radii->pixel_at(at.x, at.y)];
    }

    bool conflict(Sample a, Sample b) const {
        const std::uint32_t twice = portable::twice_metric_radius(
            static_cast<std::uint32_t>(plan_.cells().metric), radius_at(a), radius_at(b));
        return portable::are_closer(a.x, a.y, b.x, b.y, plan_.period_x, plan_.period_y,
                                    portable::metric_squared(twice));
    }

    template <typename Visit>
    static void for_each_within(std::uint32_t centre, std::uint32_t reach, std::uint32_t length,
                                std::uint32_t period, Visit visit) {
        const portable::Stretch near = portable::stretch_around(centre, reach, length, period);
        for (std::uint32_t i = 0; i < near.count; ++i)
            visit(portable::nth_of_stretch(near, i, length));
    }

    const Plan& plan_;
    std::vector<bool> is_free_;
    std::vector<std::uint32_t> free_lengths_;
    std::uint32_t widest_;
};

}  // namespace

std::unique_ptr<FreeSpace> make_cells(const Plan& plan) {
    return std::make_unique<Cells>(plan);
}

}  // namespace lacuna::reference
