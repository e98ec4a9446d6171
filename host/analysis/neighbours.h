// Finds the points near a point; on a torus also across its edges.
#pragma once

#include <lacuna/lacuna.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "analysis/domain.h"
#include "base/polling.h"

namespace lacuna::analysis {

class Neighbours {
public:
    // The points must lie in the domain, its upper edges included, and must outlive this object.
    Neighbours(std::span<const Point> points, const Domain& domain, Poll poll = nobody_asks);
    ~Neighbours();
    Neighbours(const Neighbours&) = delete;
    Neighbours& operator=(const Neighbours&) = delete;

    std::span<const Point> points() const { return points_; }
    const Domain& domain() const { return domain_; }

    struct Neighbour {
        std::size_t index;
        double dx;  // to the neighbour, by the shortest way
        double dy;
        double distance;
    };
    // The nearest `count` other points, nearest first; all other points if there are fewer.
    std::vector<Neighbour> nearest(std::size_t index, std::size_t count) const;

    // Entry i, for i below `bins`, is the number of pairs whose distance is in [i, i + 1) * width.
    // On a torus bins * width must not exceed half the shorter side.
    std::vector<std::uint64_t> count_pairs(double width, std::size_t bins) const;

    // The number of pairs closer than `distance`, which has the same limit.
    std::uint64_t pairs_closer_than(double distance) const { return count_pairs(distance, 1)[0]; }

    // Calls work(index) for all points, in parallel. The calling thread polls now and then.
    template <typename Work>
    void for_each_point(Work work) const {
        constexpr std::size_t kPointsPerPoll = 4096;  // a point takes some 5 microseconds
        for (std::size_t begin = 0; begin < points_.size(); begin += kPointsPerPoll) {
            poll_();
            tbb::parallel_for(begin, std::min(begin + kPointsPerPoll, points_.size()), work);
        }
    }

private:
    class Tree;

    // The distinct other points among the nearest `places` of all points and their images.
    std::vector<Neighbour> among_nearest(std::size_t index, std::size_t places) const;

    // The positions of the point and its images that can have neighbours within `reach`.
    std::vector<Point> images(Point point, double reach) const;

    std::span<const Point> points_;
    Domain domain_;
    Poll poll_;
    std::unique_ptr<Tree> tree_;
};

}  // namespace lacuna::analysis
