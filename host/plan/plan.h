// A checked request in whole numbers (docs/design.md, section 2; the units are the grid's).
#pragma once

#include <lacuna/lacuna.h>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "plan/pixels.h"
#include "plan/radius_map.h"
#include "plan/sheets.h"
#include "portable/conflict.h"

namespace lacuna {

// A position in grid units.
struct Sample {
    std::uint32_t x;
    std::uint32_t y;
    friend bool operator==(const Sample&, const Sample&) = default;
};

using portable::Sized;  // a sample with its radius

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

// The sample grid, with which samples near a position are found. Its cells are floor(r / sqrt 2)
// units wide, so that two samples never share a cell. The last cells may extend beyond the domain.
struct GridShape {
    std::uint32_t side = 0;
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
};

// Numbers of lines at either end of a plan that belong to a neighbour: see ranks/strip.h. Such
// lines are never cut.
struct Halo {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
};

// The modes' own plans (docs/design.md, section 4).
struct LinesPlan {
    bool snap = false;
    bool uniform_x = false;
};
struct ExactPlan {
    GridShape grid;
    Halo halo;
};
// Mode exact with a radius field. The first boxes are at most 2 / lines_per_radius of the least
// radius under them long. `kept` holds samples that exist already.
struct FieldPlan {
    Sheets sheets;  // of classes; x has a place for each
    std::shared_ptr<const RadiusField> radius_field;
    std::shared_ptr<const FirstBoxes> first_boxes;
    std::vector<Sized> kept;
};
struct CellsPlan {
    std::shared_ptr<const RadiusMap> radii;  // the radius of every pixel
    Metric metric = Metric::min;             // the distance for two radii
};

// Everything that decides where samples go. Equal plans give equal samples on every backend.
struct Plan {
    // Domain: [0, width) x [0, height). The longer side has 2^31 units, or fewer so that all strips
    // are equally wide: a little fewer in lines, down to 2^30 in exact. In cells the units are the
    // steps of the lattice.
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    // The domain's width and height if the axes wrap, otherwise 0.
    std::uint32_t period_x = 0;
    std::uint32_t period_y = 0;

    // L = ceil(m * W / r) strips of equal width: lines * strip_width == width. The width is even in
    // lines, a power of two in exact, and 1 in cells. With a radius field the domain is one strip.
    std::uint32_t lines = 0;
    std::uint32_t strip_width = 0;
    // The least radius of a sample, rounded up, so it is never less than the user's radius.
    std::uint32_t radius = 0;
    std::uint64_t radius_squared = 0;

    std::uint64_t seed = 0;
    std::uint64_t first_draw = 0;  // the number of the first draw
    std::uint64_t limit = 0;       // stop at this number of samples
    std::uint64_t round_size = 0;  // 0: chosen by rounds/round_policy.h
    bool tells_orders = false;     // whether rounds report the orders of the admitted draws

    // A grid unit in the user's units, along x and y. They differ by less than 2^-20.
    double unit_x = 0;
    double unit_y = 0;
    double user_radius = 0;
    double user_scale = 0;  // 0 without a field
    std::uint32_t lines_per_radius = 0;
    std::uint64_t maximal_samples = 0;   // expected number in a maximal set
    std::uint64_t expected_samples = 0;  // the same, or the limit if it is less

    std::variant<LinesPlan, ExactPlan, FieldPlan, CellsPlan> of_mode;

    bool is_exact() const { return has_grid() || has_field(); }
    bool is_cells() const { return std::holds_alternative<CellsPlan>(of_mode); }
    bool has_field() const { return std::holds_alternative<FieldPlan>(of_mode); }
    bool has_grid() const { return std::holds_alternative<ExactPlan>(of_mode); }
    const FieldPlan& field() const { return std::get<FieldPlan>(of_mode); }
    const CellsPlan& cells() const { return std::get<CellsPlan>(of_mode); }
    // In modes without them: a grid of no cells, a halo of no lines, false.
    GridShape grid() const { return has_grid() ? std::get<ExactPlan>(of_mode).grid : GridShape{}; }
    Halo halo() const { return has_grid() ? std::get<ExactPlan>(of_mode).halo : Halo{}; }
    bool snaps() const {
        const auto* const own = std::get_if<LinesPlan>(&of_mode);
        return own != nullptr && own->snap;
    }
    bool is_uniform_x() const {
        const auto* const own = std::get_if<LinesPlan>(&of_mode);
        return own != nullptr && own->uniform_x;
    }

    std::uint32_t centre_of_line(std::uint32_t line) const {
        return line * strip_width + strip_width / 2;
    }
    std::uint32_t line_of(Sample sample) const { return sample.x / strip_width; }
    // The lines that are not in the halo, and the interval of x of their strips.
    Span own_lines() const { return {halo().low, lines - halo().high}; }
    Span own_x() const { return {halo().low * strip_width, (lines - halo().high) * strip_width}; }
    // Added to the distance between sample and line before the chord is computed. In exact, chords
    // cover the strip's whole width, so that free spans contain all free space.
    std::uint32_t chord_margin() const { return is_exact() ? strip_width / 2 : 0; }
    // Converts to user units. Rounding keeps samples that are at least `radius` units apart at
    // least user_radius apart. In cells a sample lies in the middle of its cell.
    Point to_user(Sample sample) const {
        const double middle = is_cells() ? 0.5 : 0;
        return {(x_on_sheet(sample.x) + middle) * unit_x, (sample.y + middle) * unit_y};
    }
    // The class of a sample, and its x within the domain: see plan/sheets.h.
    std::uint32_t class_of(Sample sample) const {
        return has_field() ? field().sheets.of(sample.x) : 0;
    }
    std::uint32_t x_on_sheet(std::uint32_t x) const {
        return has_field() ? field().sheets.x_on_sheet(x) : x;
    }
};

// The grid of a domain that is `width` x `height` units large, for a radius.
GridShape grid_of(std::uint32_t width, std::uint32_t height, std::uint32_t radius);

// Fills in what every mode's plan takes from the request in the same way, once the plan has its
// width, height and radius. `expected` is the number of samples of a maximal set.
void finish_plan(Plan& plan, const Request& request, std::uint64_t limit, double expected);

// Throws BadRequest. request.radius must be set or, with a field, request.scale.
Plan make_plan(const Request& request);

// Sums over the pixels of one field, computed once for all its plans. An importance is taken as a
// fraction of the greatest one.
struct FieldSums {
    double greatest;
    double shares;           // sum of the fractions
    double shares_and_half;  // sum of the fractions to the power of 1.5
};
FieldSums sums_of(const Field& field, const Poll& poll = nobody_asks);
// make_plan for mode cells. The request was checked before (plan_cells.cpp).
Plan make_cells_plan(const Request& request, const FieldSums& sums, const Poll& poll = nobody_asks);

// What a plan with a radius field has at a size, its radius or scale.
struct FieldSize {
    double least_radius;
    double samples;  // expected number in a maximal set
};
// Throws BadRequest or MemoryRefused, for the request's count, scale or radius, if it is too small.
FieldSize check_radius_field_size(const Request& request, double size,
                                  const Poll& poll = nobody_asks);

// make_plan for mode exact with a radius field. The request was checked before, including the
// distances of kept points (plan_radius_field.cpp). The plan keeps `samples`, too, which lie where
// samples may lie and keep their distances.
Plan make_radius_field_plan(const Request& request, const Poll& poll = nobody_asks,
                            std::span<const Sample> samples = {});
// Whether the request needs make_radius_field_plan.
bool needs_radius_field(const Request& request);
// The scale, or without a field the radius, at which a maximal set of the request is expected to
// have `count` samples, by the formula of docs/design.md, section 5.
double radius_field_scale_for_count(const Request& request, double count,
                                    const Poll& poll = nobody_asks);

// A checked request as plans are made of it: classes give it the radius or scale of their least
// distance if it has none and no count; one class is the same as none.
Request settled(const Request& request);

// Checks everything that does not depend on the radius. Throws BadRequest.
void check_request(const Request& request);
// Checks that a field has a value for each pixel, all finite and at least 0, one above 0. Throws
// BadRequest.
void check_importance(const Field& field);
// Throws BadRequest if the field has stretches, for `who`, which knows only disks.
void check_disks(const Field& field, const char* who);

// Checks where samples may lie (check_where.cpp): the mask, the border and the kept points, but not
// the points' distances, which depend on the radius. Throws BadRequest.
void check_where(const Request& request);

// Most free spans of a line that is `radii` radii long. A line has most spans after the second or
// third round, 0.272 per radius on average, whatever m. In 18 sets of 20 to 1,000 radii no line had
// more than this function's value less 8.
double most_spans(double radii);

// The memory that a set may take if the request does not say.
std::uint64_t machine_memory_bytes();

// The radius at which a maximal set is expected to have this number of samples, at most the largest
// that the domain allows. `count` need not be a whole number.
double radius_expecting(const Request& request, double count);
// Throws BadRequest or MemoryRefused, for request.count, if it needs too small a radius.
void check_radius_for_count(const Request& request, double radius);
// In mode cells, the expected samples at a least radius of 1 user unit: the density times the
// integral of importance / greatest importance, less the lattice's loss (plan_cells.cpp).
double samples_at_radius_one(const Request& request, const FieldSums& sums);
// The scale at which a maximal set is expected to have `count` points. Throws like the next.
double scale_for_count(const Request& request, const FieldSums& sums, std::uint64_t count);
// Throws BadRequest or MemoryRefused, for request.count, if its lattice would be too large.
void check_scale_for_count(const Request& request, const FieldSums& sums, double scale);

// Throws BadRequest for `option` if `bytes` is more than the request or the machine allows.
void refuse_more_memory(const Request& request, const std::string& option, const std::string& value,
                        double bytes);
// The default m of mode cells: the least with reasonable quality in figure 4.
inline constexpr std::uint32_t kCellsPerRadius = 10;
// The request's m, or the default of its mode.
std::uint32_t lines_per_radius(const Request& request);

// The shortest decimal that reads back as the same double.
std::string shortest(double value);
// Writes a number with at most this many significant digits, as printf's %g does.
std::string rounded(double value, int digits);

}  // namespace lacuna
