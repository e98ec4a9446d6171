// Pen paths: a greedy path is improved around every dot whose neighbourhood changed, until no two
// of its segments cross.
#include "stipple/pen/pen_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "stipple/pen/greedy_path.h"
#include "stipple/pen/neighbours.h"
#include "stipple/pen/spots.h"
#include "stipple/pen/tour.h"

namespace lacuna::pen {
namespace {

constexpr double kUnits = 1 << 25;  // number of units along the longer side; see spots.h
constexpr std::size_t kNeighbours = 8;
constexpr std::size_t kBetweenAsking = 1024;

std::vector<Spot> spots_of(std::span<const Point> points) {
    Point low = points.front(), high = low;
    for (const Point& point : points) {
        low = {std::min(low.x, point.x), std::min(low.y, point.y)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
    const double longer = std::max(high.x - low.x, high.y - low.y);
    const double scale = longer > 0 ? kUnits / longer : 0;
    std::vector<Spot> spots;
    spots.reserve(points.size());
    for (const Point& point : points)
        spots.push_back(
            {std::llround((point.x - low.x) * scale), std::llround((point.y - low.y) * scale)});
    return spots;
}

// The rank of a spot on Hilbert's curve through the square of 2^26 units.
std::uint64_t hilbert_rank(Spot spot) {
    std::uint64_t rank = 0;
    for (std::int64_t side = std::int64_t{1} << 25; side > 0; side /= 2) {
        const bool right = (spot.x & side) != 0, upper = (spot.y & side) != 0;
        rank = 4 * rank + (right ? (upper ? 2U : 3U) : (upper ? 1U : 0U));
        if (upper) continue;
        if (right) spot = {~spot.x, ~spot.y};
        std::swap(spot.x, spot.y);
    }
    return rank;
}

std::vector<std::uint32_t> hilbert_order_of(std::span<const Spot> spots) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> ranked;
    ranked.reserve(spots.size());
    for (std::uint32_t i = 0; i < spots.size(); ++i) ranked.emplace_back(hilbert_rank(spots[i]), i);
    std::sort(ranked.begin(), ranked.end());
    std::vector<std::uint32_t> order;
    order.reserve(spots.size());
    for (const auto& [rank, index] : ranked) order.push_back(index);
    return order;
}

template <class Item>
std::vector<Item> picked(std::span<const Item> items, std::span<const std::uint32_t> indices) {
    std::vector<Item> all;
    all.reserve(indices.size());
    for (const std::uint32_t index : indices) all.push_back(items[index]);
    return all;
}

// Improves the tour around every spot, and again around each spot that a move changed. Then looks
// for edges that cross and for long edges, until there are none that an exchange would shorten.
std::vector<std::uint32_t> improved(Tour tour, std::size_t spots,
                                    const std::function<bool()>& may_go_on) {
    constexpr std::int64_t kLong = 10;  // times the mean
    std::vector<std::uint32_t> waiting = tour.path();
    std::vector<bool> waits(spots, true);
    std::vector<std::uint32_t> touched;
    std::size_t done = 0;
    const auto work_on = [&](std::uint32_t spot, bool improves, std::int64_t usual) {
        if (done++ % kBetweenAsking == 0 && !may_go_on()) throw Cancelled();
        touched.clear();
        if (improves) {
            waits[spot] = false;
            tour.improve(spot, touched);
        } else {
            tour.uncross(spot, usual, touched);
        }
        for (const std::uint32_t other : touched) {
            if (other == spots || waits[other]) continue;
            waits[other] = true;
            waiting.push_back(other);
        }
    };
    while (!waiting.empty()) {
        while (!waiting.empty())
            for (const std::uint32_t spot : std::exchange(waiting, {})) work_on(spot, true, 0);
        const std::int64_t usual = kLong * tour.length() / static_cast<std::int64_t>(spots);
        for (std::uint32_t spot = 0; spot < spots; ++spot) work_on(spot, false, usual);
    }
    return tour.path();
}

}  // namespace

std::vector<std::uint32_t> pen_path(std::span<const Point> points,
                                    const std::function<bool()>& may_go_on) {
    if (points.empty()) return {};
    // Sorts the dots, so that near dots are near in memory: all else is three times as fast.
    std::vector<Spot> spots = spots_of(points);
    std::vector<std::uint32_t> order = hilbert_order_of(spots);
    spots = picked<Spot>(spots, order);
    const Neighbours neighbours(spots, kNeighbours);
    Tour tour(spots, neighbours, greedy_path(spots, neighbours));
    if (!may_go_on()) throw Cancelled();
    order = picked<std::uint32_t>(order, improved(std::move(tour), spots.size(), may_go_on));
    if (order.front() > order.back()) std::reverse(order.begin(), order.end());
    return order;
}

std::vector<std::uint32_t> hilbert_order(std::span<const Point> points) {
    if (points.empty()) return {};
    return hilbert_order_of(spots_of(points));
}

double path_length(std::span<const Point> points) {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    return length;
}

}  // namespace lacuna::pen
