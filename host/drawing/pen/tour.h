// A closed tour in an array, and the moves 2-opt and Or-opt, which shorten it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "drawing/pen/neighbours.h"
#include "drawing/pen/spots.h"

namespace lacuna::pen {

// The tour visits the spots, at first in the order 0, 1, 2 ..., and one more stop, home, whose
// distance to every spot is 0. Without home the tour is an open path.
class Tour {
public:
    Tour(std::span<const Spot> spots, const Neighbours& neighbours);

    // Makes moves around a spot as long as one shortens the tour. Adds to `touched` the other stops
    // whose edges changed.
    void improve(std::uint32_t spot, std::vector<std::uint32_t>& touched);

    // The spots in the order of the tour, beginning after home.
    std::vector<std::uint32_t> path() const;

private:
    struct Segment;

    std::uint32_t home() const { return static_cast<std::uint32_t>(spots_.size()); }
    std::uint32_t next(std::uint32_t stop, bool forwards) const;
    std::int64_t between(std::uint32_t a, std::uint32_t b) const;

    bool exchange_edges(std::uint32_t a, bool forwards, std::vector<std::uint32_t>& touched);
    bool move_segment(std::uint32_t a, bool forwards, std::vector<std::uint32_t>& touched);
    bool move_segment(const Segment& segment, bool forwards, std::vector<std::uint32_t>& touched);
    void exchange(std::uint32_t a1, std::uint32_t a2, std::uint32_t b1);
    void reverse(std::uint32_t first, std::uint32_t last);

    std::span<const Spot> spots_;
    const Neighbours& neighbours_;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> place_;  // index of each stop in order_
};

}  // namespace lacuna::pen
