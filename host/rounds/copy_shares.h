// With classes: how random bits are shared among the copies (plan/class_copies.h), by weight times
// free area. Both the loop's marginal and the reference draw with it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lacuna {

class CopyShares {
public:
    // The areas of all bins up to the end of each copy, and the copies' weights.
    CopyShares(std::span<const std::uint64_t> areas_up_to, std::span<const std::uint32_t> weights);

    // The position of the random bits in the running sum of areas. It ascends with the bits.
    std::uint64_t area_at(std::uint64_t bits) const;

private:
    struct Share {
        std::uint64_t first_bits;
        std::uint64_t width;   // how many random numbers fall on the copy; 0: all
        std::uint64_t before;  // the areas of the copies before
        std::uint64_t area;
    };
    std::vector<Share> shares_;  // of the copies that have some
};

}  // namespace lacuna
