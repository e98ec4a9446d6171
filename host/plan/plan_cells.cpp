// The plan of mode cells: a lattice that is fine enough for the least radius, and the radius map on
// it (section 4.2).
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/number_text.h"
#include "checks/domain.h"
#include "checks/numbers.h"
#include "plan/checked_request.h"
#include "plan/make_plan.h"
#include "plan/plan.h"
#include "plan/sizes.h"

namespace lacuna {
namespace {

constexpr double kMostLatticeSteps = 1 << 17;  // along a side: squares of radii fit 64 bits
// A lattice of m steps per radius loses this fraction / m of the samples. Measured with constant
// fields, m from 3 to 40 (docs/cells.md).
constexpr double kLatticeLoss = 0.47;

constexpr int kDigits = 6;  // of numbers in messages

// Memory that a run needs at its peak: a bit for each lattice point, the map, and points.
double memory_of_lattice(const Request& request, double lattice_points, double points) {
    constexpr double kBytesPerPixel = 12, kBytesPerPoint = 64;
    const auto pixels = static_cast<double>(request.field->importance.size());
    return lattice_points / 8 + pixels * kBytesPerPixel + points * kBytesPerPoint;
}

struct LatticeOfPlan {
    double least_radius;
    double lines;
    double height;
};

// Distances are counted in the shorter step, so along the longer step samples are this much farther
// apart than they need be.
constexpr double kMostUneven = 1.01;

// Section 4.2: m / r_min lines. The step along y is nearly the same, so that the height is a whole
// number of steps. Where few steps fit in the height, rounding their number up may make them much
// shorter. Then there are more lines, so that the step along x is as short.
LatticeOfPlan lattice_of(const Request& request, const FieldSums& sums, double scale) {
    LatticeOfPlan lattice{scale / std::sqrt(sums.greatest), 0, 0};
    lattice.lines = std::max(
        1.0, std::ceil(lines_per_radius(request) * request.domain.width / lattice.least_radius));
    const double height = lattice.lines * request.domain.height / request.domain.width;
    lattice.height = std::max(1.0, std::round(height));
    if (lattice.height > kMostUneven * height)
        lattice.lines = std::round(lattice.height * request.domain.width / request.domain.height);
    return lattice;
}

void check_lattice(const Request& request, const std::string& option, const std::string& value,
                   const LatticeOfPlan& lattice, double samples) {
    const double longer = std::max(lattice.lines, lattice.height);
    if (!(longer <= kMostLatticeSteps))
        throw BadRequest(option, value,
                         "makes the least radius " + rounded(lattice.least_radius, kDigits) +
                             " and the lattice " + rounded(longer, kDigits) +
                             " steps long, of at most " + shortest(kMostLatticeSteps) +
                             ": ask for " +
                             (option == "count" ? "fewer points" : "a larger scale") +
                             " or fewer lines per radius");
    refuse_more_memory(request, option, value,
                       memory_of_lattice(request, lattice.lines * lattice.height, samples));
}

}  // namespace

FieldSums sums_of(const Field& field, const Poll& poll) {
    const std::vector<double>& importance = field.importance;
    FieldSums sums{*std::max_element(importance.begin(), importance.end()), 0, 0};
    for_each_polled(importance.size(), poll, [&](std::size_t i) {
        const double share = importance[i] / sums.greatest;
        sums.shares += share;
        sums.shares_and_half += share * std::sqrt(share);
    });
    return sums;
}

double samples_at_radius_one(const Request& request, const FieldSums& sums) {
    const double sum =
        sums.shares - kLatticeLoss / lines_per_radius(request) * sums.shares_and_half;
    return kTorusDensity * sum / static_cast<double>(request.field->importance.size()) *
           request.domain.width * request.domain.height;
}

void check_scale_for_count(const Request& request, const FieldSums& sums, double scale) {
    check_lattice(request, "count", std::to_string(*request.count),
                  lattice_of(request, sums, scale), static_cast<double>(*request.count));
}

double scale_for_count(const Request& request, const FieldSums& sums, std::uint64_t count) {
    const double scale =
        std::sqrt(samples_at_radius_one(request, sums) / static_cast<double>(count)) *
        std::sqrt(sums.greatest);
    check_lattice(request, "count", std::to_string(count), lattice_of(request, sums, scale),
                  static_cast<double>(count));
    return scale;
}

Plan make_cells_plan(const CheckedRequest& checked, const FieldSums& sums, const Poll& poll) {
    const Request& request = *checked;
    const double scale = *request.scale;
    check_positive("scale", scale);
    const LatticeOfPlan lattice = lattice_of(request, sums, scale);
    const double expected =
        samples_at_radius_one(request, sums) / (lattice.least_radius * lattice.least_radius);
    check_lattice(request, "scale", shortest(scale), lattice, expected);
    const bool torus = request.domain.wraps();

    Plan plan;
    plan.lines = plan.width = static_cast<std::uint32_t>(lattice.lines);
    plan.height = static_cast<std::uint32_t>(lattice.height);
    plan.strip_width = 1;
    const double step =
        std::min(request.domain.width / lattice.lines, request.domain.height / lattice.height);
    plan.of_mode =
        CellsPlan{.radii = std::make_shared<const RadiusMap>(
                      *request.field, scale, request.metric, plan.lines, plan.height,
                      RadiusMap::Step{step, lost_at_corner(request.domain)}, torus, poll),
                  .metric = request.metric};
    plan.radius =
        static_cast<std::uint32_t>(std::min(lattice.least_radius / step, 2 * kMostLatticeSteps)) +
        1;
    plan.user_radius = lattice.least_radius;
    plan.user_scale = scale;
    finish_plan(plan, request, request.limit.value_or(std::numeric_limits<std::uint64_t>::max()),
                expected);
    return plan;
}

}  // namespace lacuna
