// The plan of mode cells: a lattice that is fine enough for the least radius, and the radius map on
// it (section 4.2).
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "plan/plan.h"

namespace lacuna {
namespace {

constexpr double kMostLatticeSteps = 1 << 17;  // along a side: squares of radii fit 64 bits
// A lattice of m steps per radius loses this fraction / m of the samples. Measured with constant
// fields, m from 3 to 40 (docs/cells.md).
constexpr double kLatticeLoss = 0.47;

// At attempt n, counted from 0, there is room for kSpare^(1 + n (n + 1) / 2) times the count.
constexpr double kSpare = 1.015;

std::uint32_t cells_per_radius(const Request& request) {
    return request.lines_per_radius.value_or(kCellsPerRadius);
}

// Expected samples at a least radius of 1: the density times the integral of the importance in
// units of the greatest (docs/design.md, section 5). The lattice's loss where radii are small is
// subtracted.
double samples_at_radius_one(const Request& request, const FieldSums& sums) {
    const double sum =
        sums.shares - kLatticeLoss / cells_per_radius(request) * sums.shares_and_half;
    return kTorusDensity * sum / static_cast<double>(request.field->importance.size()) *
           request.width * request.height;
}

std::string short_text(double value) {
    std::ostringstream out;
    out << value;  // six digits
    return out.str();
}

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

// Section 4.2: m / r_min lines. The step along y is nearly the same, so that the height is a whole
// number of steps. If the height is less than half a step, steps are as long as the height.
LatticeOfPlan lattice_of(const Request& request, const FieldSums& sums, double scale) {
    LatticeOfPlan lattice{scale / std::sqrt(sums.greatest), 0, 0};
    lattice.lines =
        std::max(1.0, std::ceil(cells_per_radius(request) * request.width / lattice.least_radius));
    lattice.height = std::round(lattice.lines * request.height / request.width);
    if (lattice.height < 1) {
        lattice.lines = std::ceil(request.width / request.height);
        lattice.height = 1;
    }
    return lattice;
}

void check_lattice(const Request& request, const std::string& option, const std::string& value,
                   const LatticeOfPlan& lattice, double samples) {
    const double longer = std::max(lattice.lines, lattice.height);
    if (!(longer <= kMostLatticeSteps))
        throw BadRequest(option, value,
                         "makes the least radius " + short_text(lattice.least_radius) +
                             " and the lattice " + short_text(longer) + " steps long, of at most " +
                             shortest(kMostLatticeSteps) + ": ask for " +
                             (option == "count" ? "fewer points" : "a larger scale") +
                             " or fewer lines per radius");
    refuse_more_memory(request, option, value,
                       memory_of_lattice(request, lattice.lines * lattice.height, samples));
}

// The scale, after a check that a request for a count may use it.
double checked_scale(const Request& request, const FieldSums& sums, std::uint64_t count,
                     double scale) {
    check_lattice(request, "count", std::to_string(count), lattice_of(request, sums, scale),
                  static_cast<double>(count));
    return scale;
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

double scale_for_count(const Request& request, const FieldSums& sums, std::uint64_t count) {
    const double least_radius =
        std::sqrt(samples_at_radius_one(request, sums) / static_cast<double>(count));
    return checked_scale(request, sums, count, least_radius * std::sqrt(sums.greatest));
}

double scale_for_count(const Request& request, const FieldSums& sums, std::uint64_t count,
                       const Request& pilot, std::uint64_t pilot_count, int attempt) {
    // The pilot's lattice is coarser, which is corrected as in a smooth field. A pilot without
    // points has a lattice that missed all pixels with importance, and counts as half a point.
    const double finer = samples_at_radius_one(request, sums) / samples_at_radius_one(pilot, sums);
    const double maximal = std::max(static_cast<double>(pilot_count), 0.5) * finer;
    const auto least = static_cast<double>(count);
    const double wanted = (least + 4 * kCountDeviation * std::sqrt(least)) *
                          std::pow(kSpare, 1 + attempt * (attempt + 1) / 2);
    return checked_scale(request, sums, count, *pilot.scale * std::sqrt(maximal / wanted));
}

Plan make_cells_plan(const Request& request, const FieldSums& sums, const Poll& poll) {
    const double scale = *request.scale;
    if (!std::isfinite(scale) || scale <= 0)
        throw BadRequest("scale", shortest(scale), "must be a finite number greater than 0");
    const LatticeOfPlan lattice = lattice_of(request, sums, scale);
    const double expected =
        samples_at_radius_one(request, sums) / (lattice.least_radius * lattice.least_radius);
    check_lattice(request, "scale", shortest(scale), lattice, expected);
    const bool torus = request.boundary == Boundary::torus;

    Plan plan{};
    plan.mode = Mode::cells;
    plan.lines = plan.width = static_cast<std::uint32_t>(lattice.lines);
    plan.height = static_cast<std::uint32_t>(lattice.height);
    plan.strip_width = 1;
    plan.period_x = torus ? plan.width : 0;
    plan.period_y = torus ? plan.height : 0;
    plan.unit_x = request.width / lattice.lines;
    plan.unit_y = request.height / lattice.height;
    const double step = std::min(plan.unit_x, plan.unit_y);
    plan.radii = std::make_shared<const RadiusMap>(*request.field, scale, request.metric,
                                                   plan.lines, plan.height, step, torus, poll);
    plan.metric = request.metric;
    plan.radius =
        static_cast<std::uint32_t>(std::min(lattice.least_radius / step, 2 * kMostLatticeSteps)) +
        1;
    plan.radius_squared = std::uint64_t{plan.radius} * plan.radius;
    plan.user_radius = lattice.least_radius;
    plan.user_scale = scale;
    plan.lines_per_radius = cells_per_radius(request);
    plan.round_size = request.round_size;
    plan.seed = request.seed;
    plan.limit = request.limit.value_or(std::numeric_limits<std::uint64_t>::max());
    plan.maximal_samples = static_cast<std::uint64_t>(std::min(expected, 1e18)) + 1;
    plan.expected_samples = std::min(plan.limit, plan.maximal_samples);
    return plan;
}

}  // namespace lacuna
