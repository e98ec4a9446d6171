// Descent of the Gaussian energy in whole numbers: the domain, its tables, and where samples are
// (docs/design.md, section 9).
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <span>
#include <vector>

#include "base/polling.h"
#include "portable/gaussian.h"

namespace lacuna::relaxing {

// A position in units: see portable/gaussian.h.
struct Spot {
    std::uint32_t x;
    std::uint32_t y;
    friend bool operator==(const Spot&, const Spot&) = default;
};

// Equal fields and spots give equal spots on every backend.
struct GaussianField {
    portable::GaussianDomain domain;
    std::vector<std::int32_t> weights;  // by squared distance; 2 more than GAUSSIAN_ENTRIES
    // By the distance from an edge, 2 more each than GAUSSIAN_EDGE_ENTRIES: exp(-d^2 / 2), and its
    // integral from the edge on.
    std::vector<std::int32_t> edge_pulls;
    std::vector<std::int32_t> edge_areas;
    // For each row of cells from a sample's own one up or down, how many columns to either side may
    // hold neighbours.
    std::vector<std::uint32_t> column_reaches;
};

// A field for `points` points, at least one. Throws BadRequest.
GaussianField make_gaussian(std::size_t points, const RelaxOptions& options);

// The starting positions. No two are equal as long as there are free positions. Throws BadRequest
// if a point lies outside the domain, or if too many lie in one place.
std::vector<Spot> spots_of(std::span<const Point> points, const GaussianField& field,
                           const RelaxOptions& options, const Poll& poll);

// The length of step `step`, of steps 0, 1, ..., in 1/65536 of the momentum.
constexpr std::uint32_t gaussian_pace(std::uint32_t step) {
    constexpr std::uint32_t kQuarter = 16384, kSlower = 1500;
    return static_cast<std::uint32_t>(std::uint64_t{kQuarter} * kSlower / (kSlower + step));
}

// The forces of a box on a sample there; none on a torus.
struct Force {
    std::int64_t x;
    std::int64_t y;
};
Force force_of_edges(const GaussianField& field, const Spot& spot);

}  // namespace lacuna::relaxing
