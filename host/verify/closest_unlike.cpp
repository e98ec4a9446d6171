// A tree of the others, halved along the longer side of the box around them. Each of the ones asks
// it for a pair of a lower ratio than the lowest found until now.
#include "verify/closest_unlike.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace lacuna::verify {
namespace {

class Tree {
public:
    explicit Tree(std::span<const Disk> disks) : disks_(disks), order_(disks.size()) {
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        nodes_.reserve(2 * disks.size() / kFew + 2);
        if (!disks.empty()) build(0, disks.size());
    }

    // Lowers `pair` to the closest one of the sample at `at`. `blur` is the largest error of a
    // distance; pairs that might be closer are measured by `ratio_with`.
    template <typename Measure>
    void search(Point at, double radius, double blur, Pair& pair, Measure measure) const {
        if (!nodes_.empty()) visit(0, at, radius, blur, pair, measure);
    }

private:
    static constexpr std::size_t kFew = 8;
    struct Node {
        double left, right, bottom, top;
        double greatest;  // radius
        std::size_t begin, end;
        std::size_t high = 0;  // the second part; the first one follows the node. 0: no parts
    };

    std::size_t build(std::size_t begin, std::size_t end) {
        const std::size_t index = nodes_.size();
        const Disk& first = disks_[order_[begin]];
        Node node{first.at.x, first.at.x, first.at.y, first.at.y, 0, begin, end};
        for (std::size_t i = begin; i < end; ++i) {
            const Disk& disk = disks_[order_[i]];
            node.left = std::min(node.left, disk.at.x);
            node.right = std::max(node.right, disk.at.x);
            node.bottom = std::min(node.bottom, disk.at.y);
            node.top = std::max(node.top, disk.at.y);
            node.greatest = std::max(node.greatest, disk.radius);
        }
        nodes_.push_back(node);
        if (end - begin <= kFew) return index;
        const bool is_wide = node.right - node.left >= node.top - node.bottom;
        const std::size_t middle = begin + (end - begin) / 2;
        const auto at = [&](std::size_t i) {
            return order_.begin() + static_cast<std::ptrdiff_t>(i);
        };
        std::nth_element(at(begin), at(middle), at(end), [&](std::size_t a, std::size_t b) {
            return is_wide ? disks_[a].at.x < disks_[b].at.x : disks_[a].at.y < disks_[b].at.y;
        });
        build(begin, middle);
        const std::size_t high = build(middle, end);
        nodes_[index].high = high;
        return index;
    }

    // The least ratio that a sample of the node may have, up to the blur of the distance.
    double least_ratio(const Node& node, Point at, double radius, double blur) const {
        const double dx = std::max({node.left - at.x, at.x - node.right, 0.0});
        const double dy = std::max({node.bottom - at.y, at.y - node.top, 0.0});
        return (std::sqrt(dx * dx + dy * dy) - blur) / std::min(radius, node.greatest) *
               (1 - 1e-12);
    }

    template <typename Measure>
    void visit(std::size_t index, Point at, double radius, double blur, Pair& pair,
               Measure& measure) const {
        const Node& node = nodes_[index];
        if (pair.ratio <= 0 || least_ratio(node, at, radius, blur) > pair.ratio) return;
        if (node.high == 0) {
            for (std::size_t i = node.begin; i < node.end; ++i) measure(order_[i], pair);
            return;
        }
        const std::size_t low = index + 1;
        const bool is_high_nearer = least_ratio(nodes_[node.high], at, radius, blur) <
                                    least_ratio(nodes_[low], at, radius, blur);
        visit(is_high_nearer ? node.high : low, at, radius, blur, pair, measure);
        visit(is_high_nearer ? low : node.high, at, radius, blur, pair, measure);
    }

    std::span<const Disk> disks_;
    std::vector<std::size_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace

Pair closest_unlike(const Domain& domain, std::span<const Disk> ones, std::span<const Disk> others,
                    double below, const Patience& patience) {
    constexpr std::size_t kOnesPerLook = 1024;
    const Tree tree(others);
    Pair pair;
    pair.ratio = below;
    bool is_found = false;
    for (std::size_t i = 0; i < ones.size(); ++i) {
        if (i % kOnesPerLook == 0) patience.look();
        const Disk& one = ones[i];
        const auto measure = [&](std::size_t other, Pair& closest) {
            const double distance = domain.distance(one.at, others[other].at);
            const double limit = std::min(one.radius, others[other].radius);
            if (distance / limit >= closest.ratio) return;
            closest = {i, other, distance, limit, distance / limit};
            is_found = true;
        };
        const int images = domain.torus ? 1 : 0;
        for (int across = -images; across <= images; ++across)
            for (int up = -images; up <= images; ++up)
                tree.search({one.at.x + across * domain.width, one.at.y + up * domain.height},
                            one.radius, domain.torus ? domain.rounding_of_given() : 0, pair,
                            measure);
    }
    return is_found ? pair : Pair{};
}

}  // namespace lacuna::verify
