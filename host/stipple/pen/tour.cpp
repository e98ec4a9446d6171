// Moves of 2-opt (Croes 1958) and Or-opt (Or 1976) between near spots. A move reverses the shorter
// part of the tour, as in Johnson and McGeoch, "The Traveling Salesman Problem: A Case Study in
// Local Optimization" (1997).
#include "stipple/pen/tour.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "base/polling.h"

namespace lacuna::pen {
namespace {

constexpr std::size_t kLongestSegment = 3;
// A move replaces at most three distances, each of which is rounded down by less than 1. If it
// saves this much in whole numbers, it shortens the tour. All moves do, so they come to an end.
constexpr std::int64_t kSurely = 3;

// 1 if c lies to the left of the way from a to b, -1 to the right, 0 on a line with both.
int side_of(const Spot& a, const Spot& b, const Spot& c) {
    const std::int64_t area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    return (area > 0 ? 1 : 0) - (area < 0 ? 1 : 0);
}

// Whether two edges have a point in common that is an end of neither and do not lie on one line.
bool cross(const Spot& a, const Spot& b, const Spot& c, const Spot& d) {
    return side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0;
}

}  // namespace

Tour::Tour(std::span<const Spot> spots, const Neighbours& neighbours,
           std::vector<std::uint32_t> path)
    : spots_(spots), neighbours_(neighbours), order_(std::move(path)), place_(spots.size() + 1) {
    order_.push_back(home());
    for (std::uint32_t i = 0; i < order_.size(); ++i) place_[order_[i]] = i;
}

std::uint32_t Tour::next(std::uint32_t stop, bool forwards) const {
    const std::uint32_t place = place_[stop];
    if (forwards) return order_[place == home() ? 0 : place + 1];
    return order_[place == 0 ? home() : place - 1];
}

std::int64_t Tour::between(std::uint32_t a, std::uint32_t b) const {
    return a == home() || b == home() ? 0 : distance(spots_[a], spots_[b]);
}

void Tour::reverse(std::uint32_t first, std::uint32_t last) {
    const auto stops = static_cast<std::uint32_t>(order_.size());
    std::uint32_t length = (last >= first ? last - first : last + stops - first) + 1;
    if (length > stops - length) {  // reversing the other part makes the same tour
        first = std::exchange(last, first == 0 ? stops - 1 : first - 1);
        first = first + 1 == stops ? 0 : first + 1;
        length = stops - length;
    }
    for (std::uint32_t swaps = length / 2; swaps > 0; --swaps) {
        std::swap(order_[first], order_[last]);
        place_[order_[first]] = first;
        place_[order_[last]] = last;
        first = first + 1 == stops ? 0 : first + 1;
        last = last == 0 ? stops - 1 : last - 1;
    }
}

// Replaces the edges a1-a2 and b1-b2 by a1-b1 and a2-b2, where b2 follows b1 in the direction in
// which a2 follows a1.
void Tour::exchange(std::uint32_t a1, std::uint32_t a2, std::uint32_t b1) {
    if (next(a1, true) == a2)
        reverse(place_[a2], place_[b1]);
    else
        reverse(place_[b1], place_[a2]);
}

// 2-opt: replaces the edge that leaves a by an edge to a nearer stop.
bool Tour::exchange_edges(std::uint32_t a, bool forwards, std::vector<std::uint32_t>& touched) {
    const std::uint32_t b = next(a, forwards);
    const std::int64_t ab = between(a, b);
    for (const std::uint32_t c : neighbours_.of(a)) {
        const std::int64_t ac = between(a, c);
        if (ac >= ab) return false;
        const std::uint32_t d = next(c, forwards);
        if (ab + between(c, d) < ac + between(b, d) + kSurely) continue;
        exchange(a, b, c);
        touched.insert(touched.end(), {b, c, d});
        return true;
    }
    return false;
}

// 2-opt among all stops that are nearer to a than the next one, b. Of two edges whose exchange
// shortens the tour, the longer one has an end to which an end of the other one is nearer than its
// own other end. So every such pair is found from an end of its longer edge.
bool Tour::uncross(std::uint32_t a, bool forwards, std::int64_t usual,
                   std::vector<std::uint32_t>& touched) {
    const std::uint32_t b = next(a, forwards);
    if (b == home()) return false;
    const std::int64_t ab = between(a, b), squared = squared_distance(spots_[a], spots_[b]);
    std::span<const std::uint32_t> nearer = neighbours_.of(a);
    std::vector<std::uint32_t> all;
    if (squared_distance(spots_[a], spots_[nearer.back()]) < squared) {
        nearer = all = neighbours_.nearer(a, squared);
        ask_after(all.size());
    }
    std::int64_t most = 0;
    std::uint32_t best = home();
    for (const std::uint32_t c : nearer) {
        if (c == a || squared_distance(spots_[a], spots_[c]) >= squared) continue;
        const std::uint32_t d = next(c, forwards);
        const bool do_cross = d != home() && cross(spots_[a], spots_[b], spots_[c], spots_[d]);
        if (!do_cross && ab <= usual) continue;
        const std::int64_t saved = ab + between(c, d) - between(a, c) - between(b, d);
        if (!do_cross && saved < kSurely) continue;
        if (best != home() && (saved < most || (saved == most && c > best))) continue;
        most = saved;
        best = c;
    }
    if (best == home()) return false;
    touched.insert(touched.end(), {a, b, best, next(best, forwards)});
    exchange(a, b, best);
    return true;
}

// Up to three stops that lie between `before` and `after`, in either direction of the tour.
struct Tour::Segment {
    std::uint32_t before;
    std::uint32_t after;
    std::array<std::uint32_t, kLongestSegment> stops;
    std::size_t length;

    std::uint32_t first() const { return stops[0]; }
    std::uint32_t last() const { return stops[length - 1]; }
    bool has(std::uint32_t stop) const {
        const auto* end = stops.begin() + length;
        return std::find(stops.begin(), end, stop) != end;
    }
};

// Or-opt: moves a segment of up to three stops to another position near a. The segment begins with
// a and extends away from the edge that leaves a.
bool Tour::move_segment(std::uint32_t a, bool forwards, std::vector<std::uint32_t>& touched) {
    Segment segment{next(a, forwards), 0, {}, 0};
    std::uint32_t stop = a;
    while (segment.length < kLongestSegment) {
        segment.stops[segment.length++] = stop;
        segment.after = next(stop, !forwards);
        if (stop == home() || segment.after == segment.before) return false;
        if (move_segment(segment, forwards, touched)) return true;
        stop = segment.after;
    }
    return false;
}

// Moves the segment between c, which is near a, and d beside it:
//   b [a .. e] p ... c d   becomes   b p ... c [a .. e] d
//   b [a .. e] p ... d c   becomes   b p ... d [e .. a] c
bool Tour::move_segment(const Segment& segment, bool forwards,
                        std::vector<std::uint32_t>& touched) {
    const std::uint32_t a = segment.first(), e = segment.last();
    const std::uint32_t b = segment.before, p = segment.after;
    const std::int64_t freed = between(a, b) + between(e, p) - between(b, p);
    for (const std::uint32_t c : neighbours_.of(a)) {
        const std::int64_t ac = between(a, c);
        if (ac >= freed) return false;
        if (segment.has(c)) continue;
        for (const bool is_beyond : {true, false}) {
            const std::uint32_t d = next(c, is_beyond != forwards);
            if (segment.has(d) || freed + between(c, d) < ac + between(e, d) + kSurely) continue;
            if (is_beyond) {
                exchange(b, a, c);
                exchange(p, e, a);
                exchange(b, c, p);
            } else {
                exchange(b, a, d);
                exchange(b, d, p);
            }
            touched.insert(touched.end(), {b, c, d, e, p});
            return true;
        }
    }
    return false;
}

void Tour::improve(std::uint32_t stop, std::vector<std::uint32_t>& touched) {
    const auto improve_once = [&] {
        for (const bool forwards : {true, false})
            if (exchange_edges(stop, forwards, touched) || move_segment(stop, forwards, touched))
                return true;
        return false;
    };
    while (improve_once()) {
    }
}

void Tour::uncross(std::uint32_t stop, std::int64_t usual, std::vector<std::uint32_t>& touched) {
    while (uncross(stop, true, usual, touched) || uncross(stop, false, usual, touched)) {
    }
}

std::int64_t Tour::length() const {
    std::int64_t length = 0;
    for (const std::uint32_t stop : order_) length += between(stop, next(stop, true));
    return length;
}

std::vector<std::uint32_t> Tour::path() const {
    std::vector<std::uint32_t> path;
    path.reserve(spots_.size());
    for (std::uint32_t stop = next(home(), true); stop != home(); stop = next(stop, true))
        path.push_back(stop);
    return path;
}

}  // namespace lacuna::pen
