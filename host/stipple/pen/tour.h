// A closed tour in an array, and the moves 2-opt and Or-opt, which shorten it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "stipple/pen/neighbours.h"
#include "stipple/pen/spots.h"

namespace lacuna::pen {

// The tour visits the spots, at first along `path`, and one more stop, home, whose distance to
// every spot is 0. Without home the tour is an open path.
class Tour {
public:
    Tour(std::span<const Spot> spots, const Neighbours& neighbours,
         std::vector<std::uint32_t> path);

    // Makes moves around a spot as long as one shortens the tour. Adds to `touched` the other stops
    // whose edges changed.
    void improve(std::uint32_t spot, std::vector<std::uint32_t>& touched);

    // Exchanges an edge of a spot and any other edge, however far apart their ends are, as long as
    // two edges cross, or the spot's edge is longer than `usual` and an exchange shortens the tour.
    // Adds the stops whose edges changed to `touched`. If that are none for all spots, no two edges
    // cross, and no edge that is longer than `usual` can be exchanged to shorten the tour.
    void uncross(std::uint32_t spot, std::int64_t usual, std::vector<std::uint32_t>& touched);

    // In the unit of distance().
    std::int64_t length() const;

    // The spots in the order of the tour, beginning after home.
    std::vector<std::uint32_t> path() const;

private:
    struct Segment;

    std::uint32_t home() const { return static_cast<std::uint32_t>(spots_.size()); }
    std::uint32_t next(std::uint32_t stop, bool forwards) const;
    std::int64_t between(std::uint32_t a, std::uint32_t b) const;

    bool exchange_edges(std::uint32_t a, bool forwards, std::vector<std::uint32_t>& touched);
    bool uncross(std::uint32_t a, bool forwards, std::int64_t usual,
                 std::vector<std::uint32_t>& touched);
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
