// Greedy matching: shortest edges first join dots to pieces of a path. Then the ends of the pieces
// are matched again, until there is one piece.
#include "stipple/pen/greedy_path.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>

namespace lacuna::pen {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};
// The number of nearest ends that an end may be joined to. More would mean fewer rounds.
constexpr std::size_t kNearEnds = 8;
// Expected number of edges for each end, of its 8 nearest: 4.7 were measured on photographs.
constexpr std::size_t kUsualEdges = 5;

struct Edge {
    std::int64_t squared_length;
    std::uint32_t a;
    std::uint32_t b;
    friend bool operator<(const Edge& left, const Edge& right) {
        return std::tie(left.squared_length, left.a, left.b) <
               std::tie(right.squared_length, right.a, right.b);
    }
};

// The pieces of the path while it grows.
class Pieces {
public:
    explicit Pieces(std::size_t count) : links_(count, {kNone, kNone}), other_end_(count) {
        std::iota(other_end_.begin(), other_end_.end(), 0U);
    }

    // Joins the pieces that end at a and b, unless one is no end or both end the same piece.
    void join(std::uint32_t a, std::uint32_t b) {
        if (!is_end(a) || !is_end(b) || other_end_[a] == b) return;
        const std::uint32_t far_a = other_end_[a], far_b = other_end_[b];
        link(a, b);
        link(b, a);
        other_end_[far_a] = far_b;
        other_end_[far_b] = far_a;
    }

    // The ends of all pieces, in increasing order.
    std::vector<std::uint32_t> ends() const {
        std::vector<std::uint32_t> all;
        for (std::uint32_t i = 0; i < links_.size(); ++i)
            if (is_end(i)) all.push_back(i);
        return all;
    }

    // The spots of a piece in order, beginning at its end `end`.
    std::vector<std::uint32_t> walk(std::uint32_t end) const {
        std::vector<std::uint32_t> order;
        order.reserve(links_.size());
        std::uint32_t before = kNone;
        for (std::uint32_t at = end; at != kNone;) {
            order.push_back(at);
            const auto [one, two] = links_[at];
            before = std::exchange(at, one == before ? two : one);
        }
        return order;
    }

private:
    bool is_end(std::uint32_t i) const { return links_[i][1] == kNone; }
    void link(std::uint32_t from, std::uint32_t to) {
        links_[from][links_[from][0] == kNone ? 0 : 1] = to;
    }

    std::vector<std::array<std::uint32_t, 2>> links_;
    std::vector<std::uint32_t> other_end_;  // the other end of the piece; valid for ends only
};

void join_nearest(std::span<const Spot> spots, std::span<const std::uint32_t> ends,
                  const Neighbours& neighbours, Pieces& pieces) {
    // If two ends are among each other's nearest, only the first one adds the edge.
    const auto is_near = [&](std::uint32_t i, std::size_t j) {
        const std::span<const std::uint32_t> near = neighbours.of(j);
        return std::find(near.begin(), near.end(), i) != near.end();
    };
    std::vector<Edge> edges;
    edges.reserve(ends.size() * kUsualEdges);
    for (std::uint32_t i = 0; i < ends.size(); ++i)
        for (const std::uint32_t j : neighbours.of(i)) {
            if (j < i && is_near(i, j)) continue;
            const auto [a, b] = std::minmax(ends[i], ends[j]);
            edges.push_back({squared_distance(spots[a], spots[b]), a, b});
        }
    std::sort(edges.begin(), edges.end());
    for (const Edge& edge : edges) pieces.join(edge.a, edge.b);
}

}  // namespace

std::vector<std::uint32_t> greedy_path(std::span<const Spot> spots, const Neighbours& neighbours) {
    if (spots.empty()) return {};
    Pieces pieces(spots.size());
    std::vector<std::uint32_t> ends = pieces.ends();
    join_nearest(spots, ends, neighbours, pieces);
    // Stop when there is one piece, which has two ends. Each round joins at least two pieces,
    // because an end's nearest ends include one of another piece.
    for (ends = pieces.ends(); ends.size() > 2; ends = pieces.ends()) {
        std::vector<Spot> at;
        at.reserve(ends.size());
        for (const std::uint32_t end : ends) at.push_back(spots[end]);
        join_nearest(spots, ends, Neighbours(at, kNearEnds), pieces);
    }
    return pieces.walk(ends[0]);
}

}  // namespace lacuna::pen
