// Finds where outlines meet by halving a box until it has the edges of one ring alone, or few. So
// the time grows with the number of edges near which another ring has edges.
#include "domains/meetings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>

#include "base/polling.h"

namespace lacuna::domains {
namespace {

struct RingEdge {
    Point from;
    Point to;
    std::size_t ring;
};

struct Rectangle {
    Point low;
    Point high;
};

// Whether an edge comes to the rectangle or, by rounding, near it.
bool comes_to(const Rectangle& box, const RingEdge& edge) {
    constexpr double kMargin = 1e-6;  // in sides of the box
    double begin = 0;
    double end = 1;
    const auto cut = [&](double at, double step, double low, double high) {
        const double margin = kMargin * (high - low);
        const double to_low = low - margin - at, to_high = high + margin - at;
        if (step == 0) return to_low <= 0 && to_high >= 0;
        begin = std::max(begin, (step > 0 ? to_low : to_high) / step);
        end = std::min(end, (step > 0 ? to_high : to_low) / step);
        return begin <= end;
    };
    return cut(edge.from.x, edge.to.x - edge.from.x, box.low.x, box.high.x) &&
           cut(edge.from.y, edge.to.y - edge.from.y, box.low.y, box.high.y);
}

// On which side of the edge's line a point lies: 1, -1, or 0 where rounding may decide.
int side_of(const RingEdge& edge, Point point) {
    const double left = (edge.to.x - edge.from.x) * (point.y - edge.from.y);
    const double right = (edge.to.y - edge.from.y) * (point.x - edge.from.x);
    const double rounding =
        8 * std::numeric_limits<double>::epsilon() * (std::abs(left) + std::abs(right));
    return left - right > rounding ? 1 : right - left > rounding ? -1 : 0;
}

bool may_meet(const RingEdge& a, const RingEdge& b) {
    const auto are_apart = [](double a1, double a2, double b1, double b2) {
        return std::max(a1, a2) < std::min(b1, b2) || std::max(b1, b2) < std::min(a1, a2);
    };
    return !are_apart(a.from.x, a.to.x, b.from.x, b.to.x) &&
           !are_apart(a.from.y, a.to.y, b.from.y, b.to.y) &&
           side_of(a, b.from) * side_of(a, b.to) <= 0 && side_of(b, a.from) * side_of(b, a.to) <= 0;
}

class Search {
public:
    explicit Search(std::span<const PolygonRing> rings) {
        constexpr double kFar = std::numeric_limits<double>::infinity();
        Rectangle all{{kFar, kFar}, {-kFar, -kFar}};
        std::vector<std::uint32_t> edges;
        for (std::size_t i = 0; i < rings.size(); ++i)
            for (std::size_t j = 0; j < rings[i].size(); ++j) {
                const Point from = rings[i][j];
                all.low = {std::min(all.low.x, from.x), std::min(all.low.y, from.y)};
                all.high = {std::max(all.high.x, from.x), std::max(all.high.y, from.y)};
                edges.push_back(static_cast<std::uint32_t>(edges_.size()));
                edges_.push_back({from, rings[i][(j + 1) % rings[i].size()], i});
            }
        search(edges, all, 0);
    }

    RingPairs found() && { return std::move(found_); }

private:
    static constexpr int kDeepest = 40;  // halvings, 20 along each axis
    static constexpr std::size_t kFew = 16;

    void search(const std::vector<std::uint32_t>& edges, const Rectangle& box, int depth) {
        ask_after(edges.size());
        const auto is_of_first = [&](std::uint32_t i) {
            return edges_[i].ring == edges_[edges.front()].ring;
        };
        if (std::all_of(edges.begin(), edges.end(), is_of_first)) return;
        if (edges.size() <= kFew || depth == kDeepest) return compare(edges);
        Rectangle low = box, high = box;
        if (depth % 2 == 0)
            low.high.x = high.low.x = (box.low.x + box.high.x) / 2;
        else
            low.high.y = high.low.y = (box.low.y + box.high.y) / 2;
        for (const Rectangle& half : {low, high}) {
            std::vector<std::uint32_t> own;
            std::copy_if(edges.begin(), edges.end(), std::back_inserter(own),
                         [&](std::uint32_t i) { return comes_to(half, edges_[i]); });
            search(own, half, depth + 1);
        }
    }

    void compare(const std::vector<std::uint32_t>& edges) {
        for (std::size_t i = 0; i < edges.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                ask_after();
                const RingEdge &a = edges_[edges[i]], &b = edges_[edges[j]];
                if (a.ring != b.ring && may_meet(a, b)) found_.insert(std::minmax(a.ring, b.ring));
            }
    }

    std::vector<RingEdge> edges_;
    RingPairs found_;
};

}  // namespace

RingPairs meetings(std::span<const PolygonRing> rings) {
    return Search(rings).found();
}

// The points are sorted by their y, so that an edge passes only those in its rows.
std::vector<std::vector<std::size_t>> rings_around(std::span<const PolygonRing> rings) {
    struct Asked {
        Point at;
        std::size_t ring;
        bool is_around = false;
    };
    std::vector<Asked> asked;
    for (std::size_t i = 0; i < rings.size(); ++i)
        if (!rings[i].empty()) asked.push_back({rings[i].front(), i});
    const auto is_lower = [](const Asked& one, double y) { return one.at.y < y; };
    std::sort(asked.begin(), asked.end(),
              [](const Asked& a, const Asked& b) { return a.at.y < b.at.y; });
    std::vector<std::vector<std::size_t>> around(rings.size());
    for (std::size_t i = 0; i < rings.size(); ++i) {
        std::vector<Asked*> passed;
        for (std::size_t j = 0; j < rings[i].size(); ++j) {
            const Point a = rings[i][j], b = rings[i][(j + 1) % rings[i].size()];
            const double end = std::max(a.y, b.y);
            auto one = std::lower_bound(asked.begin(), asked.end(), std::min(a.y, b.y), is_lower);
            for (; one != asked.end() && one->at.y < end; ++one) {
                ask_after();
                if (one->at.x >= a.x + (one->at.y - a.y) / (b.y - a.y) * (b.x - a.x)) continue;
                one->is_around = !one->is_around;
                passed.push_back(&*one);
            }
        }
        for (Asked* const one : passed) {
            if (one->is_around && one->ring != i) around[one->ring].push_back(i);
            one->is_around = false;
        }
    }
    return around;
}

}  // namespace lacuna::domains
