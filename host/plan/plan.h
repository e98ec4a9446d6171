// A checked request in whole numbers (docs/design.md, section 2; the units are the grid's). See
// plan/make_plan.h for how it is made.
#pragma once

#include <lacuna/lacuna.h>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "plan/class_copies.h"
#include "plan/pixels.h"
#include "plan/radius_map.h"
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

class RadiusField;
struct FirstBoxes;
namespace space {
struct FirstBins;
}

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
    ClassCopies copies;  // of classes; x has a place for each
    std::shared_ptr<const RadiusField> radius_field;
    std::shared_ptr<const FirstBoxes> first_boxes;
    std::vector<Sized> kept;
};
struct CellsPlan {
    std::shared_ptr<const RadiusMap> radii;  // the radius of every pixel
    Metric metric = Metric::min;             // the distance for two radii
};

// Surfaces and volumes. Of the numbers below only the radius, those of draws and samples, and
// unit_x, the unit along all axes, have a meaning.
struct SpacePlan {
    std::shared_ptr<const space::FirstBins> first_bins;
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
    // Stop, too, at these numbers of samples of each class. Empty: at none.
    std::vector<std::uint64_t> class_limits{};
    std::uint64_t round_size = 0;  // 0: chosen by rounds/round_policy.h
    bool tells_orders = false;     // whether rounds report the orders of the admitted draws

    // The user's domain. Only its corner is used.
    Domain domain{};
    // A grid unit in the user's units, along x and y. They differ by less than 2^-20.
    double unit_x = 0;
    double unit_y = 0;
    double user_radius = 0;
    double user_scale = 0;  // 0 without a field
    std::uint32_t lines_per_radius = 0;
    std::uint64_t maximal_samples = 0;   // expected number in a maximal set
    std::uint64_t expected_samples = 0;  // the same, or the limit if it is less

    std::variant<LinesPlan, ExactPlan, FieldPlan, CellsPlan, SpacePlan> of_mode;

    bool is_exact() const { return has_grid() || begins_with_boxes(); }
    // Whether rounds draw from boxes, or from parts of a surface or a volume, from the first one
    // on.
    bool begins_with_boxes() const { return has_radius_field() || is_space(); }
    bool is_space() const { return std::holds_alternative<SpacePlan>(of_mode); }
    bool is_cells() const { return std::holds_alternative<CellsPlan>(of_mode); }
    bool has_radius_field() const { return std::holds_alternative<FieldPlan>(of_mode); }
    bool has_grid() const { return std::holds_alternative<ExactPlan>(of_mode); }
    const FieldPlan& field() const { return std::get<FieldPlan>(of_mode); }
    const SpacePlan& space() const { return std::get<SpacePlan>(of_mode); }
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
    // Converts to user units, from the domain's corner on. Rounding keeps samples that are at least
    // `radius` units apart at least user_radius apart. In cells a sample lies in the middle of its
    // cell.
    Point to_user(Sample sample) const {
        const double middle = is_cells() ? 0.5 : 0;
        return domain.at({(x_on_copy(sample.x) + middle) * unit_x, (sample.y + middle) * unit_y});
    }
    // The class of a sample, and its x within the domain: see plan/class_copies.h.
    std::uint32_t class_of(Sample sample) const {
        return has_radius_field() ? field().copies.of(sample.x) : 0;
    }
    std::uint32_t x_on_copy(std::uint32_t x) const {
        return has_radius_field() ? field().copies.x_on_copy(x) : x;
    }
};

}  // namespace lacuna
