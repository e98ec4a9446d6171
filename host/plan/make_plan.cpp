// Turns a checked request into whole numbers: the modes of lines, and what all modes have.
#include "plan/make_plan.h"
#include "checks/numbers.h"

#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/number_text.h"
#include "checks/domain.h"
#include "plan/checked_request.h"
#include "plan/kept.h"
#include "plan/radius_field.h"
#include "plan/sizes.h"
#include "portable/isqrt.h"

namespace lacuna {
namespace {

constexpr double kLongerSideUnits = 2147483648.0;   // 2^31
constexpr std::uint32_t kExactLinesPerRadius = 6;   // it decides only the speed
constexpr std::uint32_t kBoxesPerRadius = 1;        // boxes instead of lines, with a radius field
constexpr std::uint32_t kPaperLinesPerRadius = 30;  // the paper's section 5.1

// Maximal sets in a box: N r^2 over the area, and the width of the effect of the edge in radii.
constexpr double kBoxDensity = 0.69655;
constexpr double kBoxEdge = 0.666;

std::string gigabytes(double bytes) {
    return rounded(bytes / 1e9, 4) + " GB";
}

double memory_limit(const Request& request) {
    if (request.run_on.memory_limit_bytes != 0)
        return static_cast<double>(request.run_on.memory_limit_bytes);
    return static_cast<double>(machine_memory_bytes());
}

// Memory that a run needs at its peak: the spans of every line, and points in grid and user units
// with the growth of their vectors.
double memory_needed(const Request& request, double radius, double points) {
    constexpr double kBytesPerSpan = 8, kBytesPerPoint = 48;
    const double lines = std::ceil(lines_per_radius(request) * request.domain.width / radius);
    const double spans = most_spans(request.domain.height / radius);
    const double all = expected_count(request.domain, radius);
    if (!request.limit) return lines * spans * kBytesPerSpan + points * kBytesPerPoint;
    // Each sample adds at most one span to a line. Exact also has the sample grid, whose cells have
    // a radius as their diagonal, whatever the limit.
    constexpr double kBytesPerCell = 8;
    const double fewer = std::min(spans, static_cast<double>(*request.limit) + 8);
    const double cells = 2 * (request.domain.width / radius) * (request.domain.height / radius);
    const double grid = request.mode == Mode::exact ? cells * kBytesPerCell : 0;
    return std::min(lines * spans * kBytesPerSpan + all * kBytesPerPoint,
                    lines * fewer * kBytesPerSpan + grid + points * kBytesPerPoint);
}

void refuse_if_too_large(const Request& request, const std::string& option,
                         const std::string& value, double radius, double points) {
    refuse_more_memory(request, option, value, memory_needed(request, radius, points));
}

double largest_radius(const Request& request) {
    return request.domain.wraps() ? request.domain.shorter_side()
                                  : std::hypot(request.domain.width, request.domain.height);
}

void check_radius(const Request& request) {
    const double radius = *request.radius;
    const double longer = request.domain.longer_side();
    check_positive("radius", radius);
    if (radius > largest_radius(request))
        throw BadRequest("radius", shortest(radius),
                         "must be at most " + shortest(largest_radius(request)) +
                             (request.domain.wraps() ? ", the shorter side of the torus"
                                                     : ", the diagonal of the domain"));
    if (radius < longer * kSmallestRadius)
        throw BadRequest("radius", shortest(radius),
                         "must be at least " + shortest(longer * kSmallestRadius) +
                             ", the longer side / 2^20, or the grid's units run out");
    double points = expected_count(request.domain, radius);
    if (request.limit) points = std::min(points, static_cast<double>(*request.limit));
    refuse_if_too_large(request, "radius", shortest(radius), radius, points);
}

}  // namespace

std::uint32_t lines_per_radius(const Request& request) {
    if (request.paper2011.lines_per_radius) return *request.paper2011.lines_per_radius;
    switch (request.mode) {
        case Mode::exact:
            return needs_radius_field(request) ? kBoxesPerRadius : kExactLinesPerRadius;
        case Mode::lines:
            return kPaperLinesPerRadius;
        default:
            return kCellsPerRadius;
    }
}

void refuse_more_memory(const Request& request, const std::string& option, const std::string& value,
                        double bytes) {
    const double limit = memory_limit(request);
    if (bytes <= limit) return;
    throw MemoryRefused(option, value,
                        "needs about " + gigabytes(bytes) + " of memory, more than the " +
                            gigabytes(limit) + " there is");
}

double most_spans(double radii) {
    return 0.28 * radii + 1.6 * std::sqrt(radii) + 8;
}

std::uint64_t machine_memory_bytes() {
    return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
           static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

Domain domain_like(std::uint32_t columns, std::uint32_t rows, Boundary boundary) {
    const double longer = std::max(columns, rows);
    return {columns / longer, rows / longer, boundary};
}

double expected_count(const Domain& domain, double radius) {
    const double across = domain.width / radius, up = domain.height / radius;
    if (domain.wraps()) return kTorusDensity * across * up;
    return kBoxDensity * (across + kBoxEdge) * (up + kBoxEdge);
}

// Solves density * (W q + edge) (H q + edge) = count for q = 1 / r and takes the larger root.
double radius_expecting(const Request& request, double count) {
    const double most = largest_radius(request);
    if (request.domain.wraps())
        return std::min(
            most, std::sqrt(kTorusDensity * request.domain.width * request.domain.height / count));
    const double a = request.domain.width * request.domain.height;
    const double b = kBoxEdge * (request.domain.width + request.domain.height);
    const double c = kBoxEdge * kBoxEdge - count / kBoxDensity;
    return c >= 0 ? most : std::min(most, 2 * a / (std::sqrt(b * b - 4 * a * c) - b));
}

void check_radius_for_count(const Request& request, double radius) {
    const auto count = static_cast<double>(*request.count);
    refuse_if_too_large(request, "count", std::to_string(*request.count), radius, count);
    const double longer = request.domain.longer_side();
    if (radius < longer * kSmallestRadius)
        throw BadRequest("count", std::to_string(*request.count),
                         "needs a radius under the longer side / 2^20: the grid's units run out");
}

bool needs_radius_field(const Request& request) {
    return request.mode == Mode::exact &&
           (request.field != nullptr || request.places.mask != nullptr ||
            request.places.border > 0 || !request.keep.empty() || request.progressive ||
            !request.classes.names.empty());
}

Plan make_plan(const CheckedRequest& checked) {
    const Request& request = *checked;
    if (request.mode == Mode::stratified || request.mode == Mode::pixels)
        throw BadRequest("mode", std::string(name_of(request.mode)),
                         "has no rounds: must be exact, lines or cells");
    if (request.mode == Mode::cells) return make_cells_plan(checked, sums_of(*request.field));
    if (needs_radius_field(request)) {
        check_kept_distances(request);
        return make_radius_field_plan(checked);
    }
    check_radius(request);
    const double radius = *request.radius;
    const double longer = request.domain.longer_side();

    // Section 4.1: L = ceil(m W / r) lines. Strips are equally wide, their centres are whole
    // numbers.
    const double lines = std::ceil(lines_per_radius(request) * request.domain.width / radius);
    const double strip = kLongerSideUnits * (request.domain.width / longer) / lines;
    const std::uint32_t even = 2 * static_cast<std::uint32_t>(strip / 2);
    const bool is_exact = request.mode == Mode::exact;
    Plan plan;
    plan.lines = static_cast<std::uint32_t>(lines);
    plan.strip_width = is_exact ? std::bit_floor(even) : even;
    plan.width = plan.lines * plan.strip_width;
    plan.height =
        static_cast<std::uint32_t>(request.domain.height * (plan.width / request.domain.width));

    // The radius is rounded up by at least 2^-10 units, more than doubles lose when converted back,
    // and by what is lost at a corner.
    const double unit =
        std::min(request.domain.width / plan.width, request.domain.height / plan.height);
    plan.radius =
        static_cast<std::uint32_t>((radius + lost_at_corner(request.domain)) / unit + 1.0 / 1024) +
        1;
    if (is_exact)
        plan.of_mode = ExactPlan{.grid = grid_of(plan.width, plan.height, plan.radius), .halo = {}};
    else
        plan.of_mode =
            LinesPlan{.snap = request.paper2011.snap, .uniform_x = request.paper2011.uniform_x};
    plan.user_radius = radius;
    const std::uint64_t most = request.count.value_or(std::numeric_limits<std::uint64_t>::max());
    finish_plan(plan, request, std::min(most, request.limit.value_or(most)),
                expected_count(request.domain, radius));
    if (request.paper2011.uniform_x) plan.round_size = 1;
    return plan;
}

GridShape grid_of(std::uint32_t width, std::uint32_t height, std::uint32_t radius) {
    const auto side = portable::to_u32(portable::isqrt(std::uint64_t{radius} * radius / 2));
    return {.side = side, .columns = (width - 1) / side + 1, .rows = (height - 1) / side + 1};
}

void finish_plan(Plan& plan, const Request& request, std::uint64_t limit, double expected) {
    const bool torus = request.domain.wraps();
    plan.period_x = torus ? plan.width : 0;
    plan.period_y = torus ? plan.height : 0;
    plan.domain = request.domain;
    plan.unit_x = request.domain.width / plan.width;
    plan.unit_y = request.domain.height / plan.height;
    plan.radius_squared = std::uint64_t{plan.radius} * plan.radius;
    plan.lines_per_radius = lines_per_radius(request);
    plan.seed = request.seed;
    plan.round_size = request.paper2011.round_size;
    plan.limit = limit;
    plan.maximal_samples = static_cast<std::uint64_t>(std::min(expected, 1e18)) + 1;
    plan.expected_samples = std::min(plan.limit, plan.maximal_samples);
}

}  // namespace lacuna
