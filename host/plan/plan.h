// A request, checked and turned into whole numbers (docs/design.md, section 2: units of the grid).
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

// One that others placed, with the radius that it has on the plan's radius_field.
struct KeptSample {
    Sample at;
    std::uint32_t radius;
};

// A stretch of y on a line, [begin, end); mostly one where a sample may still be placed.
struct Span {
    std::uint32_t begin;
    std::uint32_t end;
    friend bool operator==(const Span&, const Span&) = default;
};

// Of maximal sets on a torus (docs/design.md, section 5): N r^2 over the area, which is random
// sequential adsorption's jamming density, and the standard deviation of N over sqrt(N).
inline constexpr double kTorusDensity = 0.69656;
inline constexpr double kCountDeviation = 0.244;

class RadiusField;
struct FirstBoxes;

// Lines at either end of a plan that belong to a neighbour: see ranks/strip.h.
struct Halo {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
};

// Everything that decides where samples go. In mode cells the grid is the lattice: a line is one of
// its columns, a strip is one unit wide, and `radius` is the least of all, rounded up. Equal plans
// give equal samples on every backend.
struct Plan {
    // Domain: [0, width) x [0, height), 2^31 units along its longer side, less where needed to make
    // the strips equally wide: a little in lines, down to 2^30 in exact.
    std::uint32_t width;
    std::uint32_t height;
    // The same where the axes wrap, 0 where they do not.
    std::uint32_t period_x;
    std::uint32_t period_y;

    std::uint32_t lines;        // L = ceil(m * W / r)
    Halo halo;                  // of them: never cut; in exact without a radius field only
    std::uint32_t strip_width;  // even; a power of two in exact; lines * strip_width == width
    std::uint32_t radius;       // rounded up: so many units are never less than the user's radius
    std::uint64_t radius_squared;
    // The sample grid, for looking up the samples near a place: its cells are floor(r / sqrt 2)
    // wide, so that two samples never share one, and the last ones may stick out.
    std::uint32_t grid_side;
    std::uint32_t grid_columns;
    std::uint32_t grid_rows;

    Mode mode;
    bool is_exact() const { return mode == Mode::exact; }
    bool is_cells() const { return mode == Mode::cells; }
    std::shared_ptr<const RadiusMap> radii;  // in cells only: the radius of every place
    Metric metric;                           // in cells only: of two radii
    // In exact where not all places are alike: their radii, and where samples may go. Then there
    // are no lines, `radius` is the least, the first boxes are no longer than 2 / lines_per_radius
    // of the least radius under them, and `kept` holds samples that lie there already.
    std::shared_ptr<const RadiusField> radius_field;
    std::shared_ptr<const FirstBoxes> first_boxes;
    std::vector<KeptSample> kept;
    bool snap;
    bool uniform_x;
    std::uint64_t limit;       // stop after so many samples
    std::uint64_t round_size;  // 0: chosen by rounds/round_policy.h
    std::uint64_t seed;
    bool tells_orders;  // rounds tell the orders of the draws that became samples

    // The user's units for one grid unit, along x and y. They differ by less than 2^-20.
    double unit_x;
    double unit_y;
    double user_radius;
    double user_scale;
    std::uint32_t lines_per_radius;
    std::uint64_t maximal_samples;   // to be expected of the maximal set
    std::uint64_t expected_samples;  // the same, or the limit if that is less

    std::uint32_t centre_of_line(std::uint32_t line) const {
        return line * strip_width + strip_width / 2;
    }
    std::uint32_t line_of(Sample sample) const { return sample.x / strip_width; }
    // The plan's own lines, and the x of their strips.
    Span own_lines() const { return {halo.low, lines - halo.high}; }
    Span own_x() const { return {halo.low * strip_width, (lines - halo.high) * strip_width}; }
    // Added to the distance of a line before its chord is found. In exact a chord is what covers
    // the whole width of the strip, so that the free spans hold all of the free space.
    std::uint32_t chord_margin() const { return is_exact() ? strip_width / 2 : 0; }
    // Rounds so that no two samples at least `radius` units apart come closer than user_radius.
    // In cells samples lie in the middle of their cells.
    Point to_user(Sample sample) const {
        const double middle = is_cells() ? 0.5 : 0;
        return {(sample.x + middle) * unit_x, (sample.y + middle) * unit_y};
    }
};

// Throws BadRequest. request.radius must be set, or request.scale in mode cells.
Plan make_plan(const Request& request);

// What the plans of one field have in common, found in one pass over it. A share is a pixel's part
// of the greatest importance.
struct FieldSums {
    double greatest;
    double shares;
    double shares_and_half;  // of shares to the power of 1.5
};
FieldSums sums_of(const Field& field, const Poll& poll = nobody_asks);
// make_plan for mode cells and a request that was checked (plan_cells.cpp).
Plan make_cells_plan(const Request& request, const FieldSums& sums, const Poll& poll = nobody_asks);

// make_plan for mode exact with a radius field and a request that was checked, also for the
// distances of kept points if they are to keep any (plan_radius_field.cpp).
Plan make_radius_field_plan(const Request& request, const Poll& poll = nobody_asks);
// Whether that is the request's plan.
bool needs_radius_field(const Request& request);
// The scale, or without a field the radius, at which the formula of docs/design.md, section 5,
// expects so many samples in a maximal set of such a request.
double radius_field_scale_for_count(const Request& request, double count,
                                    const Poll& poll = nobody_asks);

// Checks all that does not depend on the radius. Throws BadRequest.
void check_request(const Request& request);
// That a field has a value for each pixel, all finite and at least 0, and some importance. Throws
// BadRequest.
void check_importance(const Field& field);

// What a request says of where samples may lie (check_where.cpp): its mask, its border and the kept
// points, but for their distances, which depend on the radius. Throws BadRequest.
void check_where(const Request& request);

// Free spans that a line has at most, so many radii long: 0.272 a radius on average when they are
// most, after the second round or the third, whatever m; of 18 sets of 20 to 1,000 radii none had a
// line with more than this, less 8.
double most_spans(double radii);

// What a set may take unless the request says otherwise.
std::uint64_t machine_memory_bytes();

// The radius at which a maximal set holds request.count points and some to spare; more to spare
// with every attempt. Throws BadRequest.
double radius_for_count(const Request& request, int attempt);
// The same for mode cells: the scale g at which the formula of docs/design.md, section 5, expects a
// maximal set of so many.
// Throws BadRequest where its lattice would be too large.
double scale_for_count(const Request& request, const FieldSums& sums, std::uint64_t count);
// And corrected by a pilot, a maximal set of the same field: where a field is rough, min lets in
// more samples than its integral tells. With some to spare; more with every attempt.
double scale_for_count(const Request& request, const FieldSums& sums, std::uint64_t count,
                       const Request& pilot, std::uint64_t pilot_count, int attempt);

// Throws BadRequest for `option` when so many bytes are more than the request or the machine
// allows.
void refuse_more_memory(const Request& request, const std::string& option, const std::string& value,
                        double bytes);
// The m of mode cells unless the request has one: quality is reasonable from there on (figure 4).
inline constexpr std::uint32_t kCellsPerRadius = 10;
// The request's, or the mode's own.
std::uint32_t lines_per_radius(const Request& request);

// The shortest decimal that reads back as the same double.
std::string shortest(double value);

}  // namespace lacuna
