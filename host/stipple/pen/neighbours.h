// The near dots of every dot, found with a k-d tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "stipple/pen/spots.h"

namespace lacuna::pen {

// Lists of equal length, one for each spot.
class Neighbours {
public:
    // Lists the `most` nearest spots of each spot, nearest first and without the spot itself; all
    // other spots if there are fewer. Uses all cores.
    Neighbours(std::span<const Spot> spots, std::size_t most);
    ~Neighbours();

    std::span<const std::uint32_t> of(std::size_t spot) const {
        return {all_.data() + spot * each_, each_};
    }

    // All spots whose squared distance to a spot is less than this, in any order.
    std::vector<std::uint32_t> nearer(std::size_t spot, std::int64_t squared_distance) const;

private:
    struct Index;

    std::unique_ptr<const Index> index_;
    std::size_t each_;
    std::vector<std::uint32_t> all_;
};

}  // namespace lacuna::pen
