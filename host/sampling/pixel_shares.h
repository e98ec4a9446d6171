// How the samples of mode pixels are shared out among the pixels.
#pragma once

#include <lacuna/errors.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {

// How many samples each pixel should have: in proportion to its mass, but at most one. What full
// pixels have too much goes to the others.
struct PixelShares {
    static constexpr std::uint32_t kMasses = 1u << 16;  // that a pixel may have
    static constexpr std::int64_t kOne = 1 << 16;       // a sample, where shares are counted

    std::vector<std::uint16_t> masses;  // of pixels, from the lowest row up; 0: no sample there
    std::uint64_t count;                // samples on pixels that are not full
    std::uint64_t mass = 0;             // of all these pixels
    std::uint32_t full = kMasses;       // pixels of this mass or more are full
    std::vector<std::uint64_t> pixels_of_mass = std::vector<std::uint64_t>(kMasses);

    PixelShares(std::vector<std::uint16_t> the_masses, std::uint64_t the_count)
        : masses(std::move(the_masses)), count(the_count) {
        for (const std::uint16_t one : masses) ++pixels_of_mass[one];
        for (std::uint32_t i = 1; i < kMasses; ++i) mass += i * pixels_of_mass[i];
        const std::uint64_t most = masses.size() - pixels_of_mass[0];
        if (count > most)
            throw BadRequest("count", std::to_string(count),
                             "must be at most " + std::to_string(most) +
                                 ", the number of pixels where samples may lie");
        for (std::uint32_t one = kMasses - 1; count > 0 && one > 0 && one * count >= mass; --one) {
            count -= pixels_of_mass[one];
            mass -= one * pixels_of_mass[one];
            full = one;
        }
    }
    bool is_full(std::size_t pixel) const { return masses[pixel] >= full; }
    bool is_open(std::size_t pixel) const { return masses[pixel] != 0 && masses[pixel] < full; }
    // In 1 / kOne.
    std::int64_t of_mass(std::uint32_t one) const {
        if (one >= full) return kOne;
        return count == 0 ? 0 : static_cast<std::int64_t>(one * count * kOne / mass);
    }
};

}  // namespace lacuna
