// Finds the lattice point to which a site moves if it would end where there is no importance.
#pragma once

#include <cstdint>
#include <vector>

#include "base/polling.h"
#include "lattice/lattice.h"
#include "plan/pixels.h"
#include "relax/cpu/tile.h"

namespace lacuna::relaxing::cpu {

// Which pixels have importance, and which squares of 2^k x 2^k pixels.
class PixelTree {
public:
    explicit PixelTree(const Lattice& lattice, const Poll& poll);

    std::uint32_t rows() const { return rows_; }
    unsigned levels() const { return squares_.levels(); }
    bool has_importance(unsigned level, std::uint32_t column, std::uint32_t row) const {
        return squares_.at(level, row, column) != 0;
    }

private:
    static std::uint8_t either(std::uint8_t a, std::uint8_t b) { return a | b; }
    std::uint32_t rows_;
    Pyramid<std::uint8_t, either> squares_;  // row by row
};

// The lattice point with importance that is nearest to `from`: of those assigned to sites[site] or,
// without `must_be_assigned`, of all. One must exist. Ties go to the lowest row, then column.
Site nearest_point(const Scene& scene, const PixelTree& pixels, std::uint32_t site,
                   bool must_be_assigned, Site from);

}  // namespace lacuna::relaxing::cpu
