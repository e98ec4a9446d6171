// How the samples of mode pixels are shared out among the pixels.
#pragma once

#include <lacuna/errors.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "base/polling.h"

namespace lacuna {

// How many samples each pixel should have: in proportion to its mass, but at most one. What full
// pixels have too much goes to the others.
struct PixelShares {
    static constexpr std::int64_t kOne = 1 << 16;  // a sample, where shares are counted
    static constexpr double kMostMass = 0x1p62;    // of all pixels

    std::vector<std::uint64_t> masses;  // of pixels, from the lowest row up; 0: no sample there
    std::uint64_t count;                // samples on pixels that are not full
    std::uint64_t mass;                 // of all these pixels
    std::uint64_t full = std::numeric_limits<std::uint64_t>::max();  // from this mass on

    PixelShares(std::vector<std::uint64_t> the_masses, std::uint64_t the_count)
        : masses(std::move(the_masses)),
          count(the_count),
          mass(std::reduce(masses.begin(), masses.end(), std::uint64_t{0})) {
        const std::size_t none =
            static_cast<std::size_t>(std::count(masses.begin(), masses.end(), std::uint64_t{0}));
        if (count > masses.size() - none)
            throw BadRequest("count", std::to_string(count),
                             "must be at most " + std::to_string(masses.size() - none) +
                                 ", the number of pixels where samples may lie");
        while (count > 0 && fill_some()) ask_after(masses.size());
    }
    bool is_full(std::size_t pixel) const { return masses[pixel] >= full; }
    bool is_open(std::size_t pixel) const { return masses[pixel] != 0 && masses[pixel] < full; }

    // The share of each pixel, in 1 / kOne. What rounding takes from a pixel goes to the next one.
    std::vector<std::int32_t> in_parts() const {
        __extension__ using Wide = unsigned __int128;
        std::vector<std::int32_t> parts(masses.size());
        std::uint64_t rest = 0;  // of a sample's mass, in 1 / kOne
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (is_full(i)) parts[i] = kOne;
            if (!is_open(i)) continue;
            const Wide own = Wide{masses[i]} * count * kOne + rest;
            parts[i] = static_cast<std::int32_t>(own / mass);
            rest = static_cast<std::uint64_t>(own % mass);
        }
        return parts;
    }

private:
    // Makes pixels full whose share is a sample or more. Returns whether there were any.
    bool fill_some() {
        const std::uint64_t least = (mass - 1) / count + 1;
        std::uint64_t filled = 0, their_mass = 0;
        for (const std::uint64_t one : masses)
            if (one >= least && one < full) {
                ++filled;
                their_mass += one;
            }
        count -= filled;
        mass -= their_mass;
        if (filled != 0) full = least;
        return filled != 0;
    }
};

}  // namespace lacuna
