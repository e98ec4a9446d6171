// The radius map of mode cells (section 4.2): a whole-number radius for every pixel, and the
// position of the pixels on the lattice.
#pragma once

#include <lacuna/lacuna.h>
#include <cstdint>
#include <vector>

#include "base/polling.h"

namespace lacuna {

struct RadiusMap {
    // A step of the lattice in the user's units, and by how much radii are longer:
    // lost_at_corner() of checks/domain.h.
    struct Step {
        double length;
        double lost = 0;
    };
    // The map of `field` at scale g, for a lattice of lines x height points. Radii are rounded up.
    // Pixels without importance have radius 0.
    RadiusMap(const Field& field, double scale, Metric metric, std::uint32_t lines,
              std::uint32_t height, Step step, bool wraps, const Poll& poll = nobody_asks);

    std::uint32_t columns;  // pixels
    std::uint32_t rows;     // pixels
    // Both by pixel: pixel (c, r), counted from below, is at c * rows + r.
    std::vector<std::uint32_t> radii;    // in 1/256 of a lattice step: portable/metric.h
    std::vector<std::uint32_t> reaches;  // in lattice steps: conflicts are nearer, with any sample

    // For the metrics mean and max: the widest open pixel of a line limits how far away a sample
    // can block points on it. widest_rows[c * rows + i] is a row of pixel column c. The rows are
    // ordered by class (radius_class in portable/metric.h), the largest radii first, in any order
    // within a class. Empty for the metric min.
    std::vector<std::uint32_t> widest_rows;

    std::vector<std::uint32_t> column_of;   // pixel column of each line
    std::vector<std::uint32_t> row_of;      // pixel row of each lattice row
    std::vector<std::uint32_t> row_begins;  // first lattice row of each pixel row; rows + 1

    std::uint32_t pixel_at(std::uint32_t x, std::uint32_t y) const {
        return column_of[x] * rows + row_of[y];
    }

private:
    void find_reaches(Metric metric, bool wraps, const Poll& poll);
    void find_widest_rows(const Poll& poll);
};

}  // namespace lacuna
