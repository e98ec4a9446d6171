// A checked request in whole numbers (docs/design.md, section 2; the units are the grid's).
#pragma once

#include <lacuna/lacuna.h>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "plan/pixels.h"
#include "plan/radius_map.h"

namespace lacuna {

// A position in grid units.
struct Sample {
    std::uint32_t x;
    std::uint32_t y;
    friend bool operator==(const Sample&, const Sample&) = default;
};

// A sample that the request keeps, with its radius in the plan's radius_field.
struct KeptSample {
    Sample at;
    std::uint32_t radius;
};

// An interval [begin, end) of y on a line; mostly a free span.
struct Span {
    std::uint32_t begin;
    std::uint32_t end;
    friend bool operator==(const Span&, const Span&) = default;
};

// Maximal sets on a torus (docs/design.md, section 5): N r^2 over the area, which is the jamming
// density of random sequential adsorption, and the standard deviation of N over sqrt(N).
inline constexpr double kTorusDensity = 0.69656;
inline constexpr double kCountDeviation = 0.244;

class RadiusField;
struct FirstBoxes;

// Numbers of lines at either end of a plan that belong to a neighbour: see ranks/strip.h.
struct Halo {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
};

// Everything that decides where samples go. Equal plans give equal samples on every backend. In
// mode cells the grid is the lattice: a line is one of its columns, a strip is one unit wide, and
// `radius` is the least radius, rounded up.
struct Plan {
    // Domain: [0, width) x [0, height). The longer side has 2^31 units, or fewer so that all strips
    // are equally wide: a little fewer in lines, down to 2^30 in exact.
    std::uint32_t width;
    std::uint32_t height;
    // The domain's width and height if the axes wrap, otherwise 0.
    std::uint32_t period_x;
    std::uint32_t period_y;

    std::uint32_t lines;        // L = ceil(m * W / r)
    Halo halo;                  // lines that are never cut; only in exact without a radius field
    std::uint32_t strip_width;  // even; a power of two in exact; lines * strip_width == width
    std::uint32_t radius;       // rounded up, so it is never less than the user's radius
    std::uint64_t radius_squared;
    // The sample grid, with which samples near a position are found. Its cells are floor(r / sqrt
    // 2) wide, so that two samples never share a cell. The last cells may extend beyond the domain.
    std::uint32_t grid_side;
    std::uint32_t grid_columns;
    std::uint32_t grid_rows;

    Mode mode;
    bool is_exact() const { return mode == Mode::exact; }
    bool is_cells() const { return mode == Mode::cells; }
    std::shared_ptr<const RadiusMap> radii;  // only in cells: the radius of every pixel
    Metric metric;                           // only in cells: the distance for two radii
    // In exact with a radius field: the radii, and where samples may go. Then there are no lines,
    // and `radius` is the least one. The first boxes are at most 2 / lines_per_radius of the least
    // radius under them long. `kept` holds samples that exist already.
    std::shared_ptr<const RadiusField> radius_field;
    std::shared_ptr<const FirstBoxes> first_boxes;
    std::vector<KeptSample> kept;
    bool snap;
    bool uniform_x;
    std::uint64_t limit;       // stop at this number of samples
    std::uint64_t round_size;  // 0: chosen by rounds/round_policy.h
    std::uint64_t seed;
    bool tells_orders;  // whether rounds report the orders of the admitted draws

    // A grid unit in the user's units, along x and y. They differ by less than 2^-20.
    double unit_x;
    double unit_y;
    double user_radius;
    double user_scale;
    std::uint32_t lines_per_radius;
    std::uint64_t maximal_samples;   // expected number of a maximal set
    std::uint64_t expected_samples;  // the same, or the limit if it is less

    std::uint32_t centre_of_line(std::uint32_t line) const {
        return line * strip_width + strip_width / 2;
    }
    std::uint32_t line_of(Sample sample) const { return sample.x / strip_width; }
    // The lines that are not in the halo, and the interval of x of their strips.
    Span own_lines() const { return {halo.low, lines - halo.high}; }
    Span own_x() const { return {halo.low * strip_width, (lines - halo.high) * strip_width}; }
    // Added to the distance between sample and line before the chord is computed. In exact, chords
    // cover the strip's whole width, so that free spans contain all free space.
    std::uint32_t chord_margin() const { return is_exact() ? strip_width / 2 : 0; }
    // Converts to user units. Rounding keeps samples that are at least `radius` units apart at
    // least user_radius apart. In cells a sample lies in the middle of its cell.
    Point to_user(Sample sample) const {
        const double middle = is_cells() ? 0.5 : 0;
        return {(sample.x + middle) * unit_x, (sample.y + middle) * unit_y};
    }
};

// Throws BadRequest. request.radius must be set, or request.scale in mode cells.
Plan make_plan(const Request& request);

// Sums over one field, computed once for all plans of it. They are in fractions of the greatest
// importance.
struct FieldSums {
    double greatest;
    double shares;
    double shares_and_half;  // sum of fractions to the power of 1.5
};
FieldSums sums_of(const Field& field, const Poll& poll = nobody_asks);
// make_plan for mode cells. The request was checked before (plan_cells.cpp).
Plan make_cells_plan(const Request& request, const FieldSums& sums, const Poll& poll = nobody_asks);

// make_plan for mode exact with a radius field. The request was checked before, including the
// distances of kept points (plan_radius_field.cpp).
Plan make_radius_field_plan(const Request& request, const Poll& poll = nobody_asks);
// Whether the request needs make_radius_field_plan.
bool needs_radius_field(const Request& request);
// The scale, or without a field the radius, at which a maximal set of the request is expected to
// have `count` samples, by the formula of docs/design.md, section 5.
double radius_field_scale_for_count(const Request& request, double count,
                                    const Poll& poll = nobody_asks);

// Checks everything that does not depend on the radius. Throws BadRequest.
void check_request(const Request& request);
// Checks that a field has a value for each pixel, all finite and at least 0, one above 0. Throws
// BadRequest.
void check_importance(const Field& field);

// Checks where samples may lie (check_where.cpp): the mask, the border and the kept points, but not
// the points' distances, which depend on the radius. Throws BadRequest.
void check_where(const Request& request);

// Most free spans of a line that is `radii` radii long. A line has most spans after the second or
// third round, 0.272 per radius on average, whatever m. In 18 sets of 20 to 1,000 radii no line had
// more than this function's value less 8.
double most_spans(double radii);

// The memory that a set may take if the request does not say.
std::uint64_t machine_memory_bytes();

// A radius at which a maximal set has somewhat more than request.count points, and more with every
// attempt. Throws BadRequest.
double radius_for_count(const Request& request, int attempt);
// The same for mode cells: the scale g at which a maximal set is expected to have `count` points,
// by the formula of docs/design.md, section 5. Throws BadRequest if its lattice would be too large.
double scale_for_count(const Request& request, const FieldSums& sums, std::uint64_t count);
// The same, corrected by a pilot, a maximal set of the same field: in rough fields min admits more
// samples than the integral predicts. Has some points to spare, more with every attempt.
double scale_for_count(const Request& request, const FieldSums& sums, std::uint64_t count,
                       const Request& pilot, std::uint64_t pilot_count, int attempt);

// Throws BadRequest for `option` if `bytes` is more than the request or the machine allows.
void refuse_more_memory(const Request& request, const std::string& option, const std::string& value,
                        double bytes);
// The default m of mode cells: the least with reasonable quality in figure 4.
inline constexpr std::uint32_t kCellsPerRadius = 10;
// The request's m, or the default of its mode.
std::uint32_t lines_per_radius(const Request& request);

// The shortest decimal that reads back as the same double.
std::string shortest(double value);

}  // namespace lacuna
