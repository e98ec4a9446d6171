// Divides a plan's lines among the ranks.
#include "ranks/strip.h"

#include <algorithm>

#include "backends/columns.h"
#include "plan/make_plan.h"

namespace lacuna {
namespace {

std::uint64_t share(std::uint64_t all, const Plan& part, const Plan& whole) {
    return all / whole.lines * part.lines + all % whole.lines * part.lines / whole.lines + 1;
}

}  // namespace

Sample Strip::in_domain(Sample sample) const {
    const std::uint64_t x =
        std::uint64_t{first_line} * plan.strip_width + sample.x - plan.own_x().begin;
    return {static_cast<std::uint32_t>(x % domain_width), sample.y};
}

std::uint32_t most_ranks(const Plan& plan) {
    return std::max(1u, count_columns(plan) / 2);
}

Strip strip_of(const Plan& plan, std::uint32_t rank, std::uint32_t ranks) {
    const auto first_of = [&](std::uint64_t of) {
        return static_cast<std::uint32_t>(of * plan.lines / ranks);
    };
    const std::uint32_t reach = (plan.radius - 1) / plan.strip_width + 1;
    const bool wraps = plan.period_x != 0;
    Strip strip{plan, first_of(rank), plan.width};
    Plan& own = strip.plan;
    own.tells_orders = true;
    if (ranks == 1) return strip;
    const Halo halo{.low = wraps || rank > 0 ? reach : 0,
                    .high = wraps || rank + 1 < ranks ? reach : 0};
    own.lines = halo.low + (first_of(rank + 1) - first_of(rank)) + halo.high;
    own.width = own.lines * own.strip_width;
    own.period_x = 0;
    own.of_mode = ExactPlan{.grid = grid_of(own.width, own.height, own.radius), .halo = halo};
    own.maximal_samples = share(plan.maximal_samples, own, plan);
    own.expected_samples = share(plan.expected_samples, own, plan);
    return strip;
}

}  // namespace lacuna
