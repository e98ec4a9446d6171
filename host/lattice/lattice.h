// The lattice on which points are relaxed: a request in whole numbers (docs/design.md, section 9).
#pragma once

#include <lacuna/lacuna.h>
#include <cstdint>
#include <span>
#include <vector>

#include "base/polling.h"
#include "portable/power.h"
#include "portable/site_tree.h"

namespace lacuna::relaxing {

// A sample during relaxation. Units of position and weight: see portable/power.h.
struct Site {
    std::uint32_t x;
    std::uint32_t y;
    std::uint64_t weight;
    friend bool operator==(const Site&, const Site&) = default;
};

// Sums over the lattice points with importance that are assigned to one site.
struct Share {
    std::uint64_t points;
    std::uint64_t mass;
    std::uint64_t moment_x;  // masses times moment_offset
    std::uint64_t moment_y;
    friend bool operator==(const Share&, const Share&) = default;
};

constexpr std::uint32_t leaves_in(std::uint32_t points) {
    return (points - 1) / LEAF_SIDE + 1;
}

// Equal lattices and sites give equal sites on every backend.
struct Lattice {
    portable::RelaxLattice numbers;
    std::uint64_t points = 0;  // number of lattice points with importance
    // The mass of each pixel's points, as portable/power.h says: row by row from the lowest y.
    std::vector<std::uint32_t> masses;
    std::vector<std::uint8_t> exponents;  // of the masses in each leaf, row by row
    std::uint64_t greatest_mass = 0;      // of a lattice point

    Domain domain{};  // the user's; only its corner is used
    // The length of a unit, in the user's units.
    double unit_x;
    double unit_y;

    std::uint32_t stored_at(std::uint32_t column, std::uint32_t row) const {
        return masses[std::size_t{row / numbers.cut_y} * numbers.pixel_columns +
                      column / numbers.cut_x];
    }
    // The exponent of the masses in the leaf of a lattice point.
    std::uint32_t exponent_at(std::uint32_t column, std::uint32_t row) const {
        return exponents[std::size_t{row / LEAF_SIDE} * leaves_in(numbers.columns) +
                         column / LEAF_SIDE];
    }
    std::uint64_t mass_at(std::uint32_t column, std::uint32_t row) const {
        const std::uint32_t exponent = exponent_at(column, row);
        return std::uint64_t{portable::mass_in_leaf(stored_at(column, row), exponent)} << exponent;
    }
    // At a site's position; 0 if it has no importance.
    std::uint32_t stored_below(const Site& site) const {
        return stored_at(site.x / numbers.step_x, site.y / numbers.step_y);
    }
    Point to_user(const Site& site) const { return domain.at({site.x * unit_x, site.y * unit_y}); }
};

// The site after a move of way / 256 of the way to its centre of mass, with its new weight. It may
// stay where it was: portable::stays.
inline Site moved(const Lattice& lattice, Site site, const Share& share, std::uint32_t way) {
    const portable::RelaxLattice& numbers = lattice.numbers;
    const bool stays = share.mass < lattice.greatest_mass &&
                       portable::stays(share.mass, lattice.stored_below(site));
    site.weight = portable::moved_weight(numbers, site.weight, share.mass,
                                         static_cast<std::uint32_t>(share.points));
    if (stays) return site;
    const std::uint32_t x = portable::centre_of_mass(
        share.moment_x, share.mass, site.x, numbers.step_x, numbers.columns, numbers.period_x);
    const std::uint32_t y = portable::centre_of_mass(
        share.moment_y, share.mass, site.y, numbers.step_y, numbers.rows, numbers.period_y);
    site.x =
        portable::moved_place(site.x, x, way, numbers.columns * numbers.step_x, numbers.period_x);
    site.y = portable::moved_place(site.y, y, way, numbers.rows * numbers.step_y, numbers.period_y);
    return site;
}

// Converts a user's coordinate, from the domain's corner on, on an axis of `length` units. An upper
// edge that wraps becomes the lower one.
std::uint32_t unit_of(double coordinate, double side, std::uint32_t length, bool wraps);
// Throws BadRequest, which names the point by its number.
void check_in_domain(std::size_t number, const Point& point, const RelaxOptions& options);

// Throws BadRequest.
inline constexpr std::uint32_t kMostIterations = 10000;
void check_options(const RelaxOptions& options);

// The field, or a field of one pixel where there is none.
const Field& field_or_even(const Field* field);

// Importance in whole numbers: in proportion and rounded, but at least 1 where it is not 0, and row
// by row from the lowest y. The least has 10 bits, or fewer if the sum would otherwise be over
// `most`; the greatest has at least 16 and at most 52.
std::vector<std::uint64_t> masses_of(const Field& field, double most, const Poll& poll);

// A lattice for `points` points, at least one. Throws BadRequest.
Lattice make_lattice(std::size_t points, const Field* field, const RelaxOptions& options,
                     const Poll& poll = nobody_asks);

// The same lattice for other points and for a field with as many pixels.
Lattice with_field(Lattice lattice, std::size_t points, const Field& field, const Poll& poll);

// The starting positions. No two are equal as long as there are free positions. Throws BadRequest
// if a point lies outside the domain.
std::vector<Site> sites_of(std::span<const Point> points, const Lattice& lattice,
                           const RelaxOptions& options, const Poll& poll = nobody_asks);

}  // namespace lacuna::relaxing
