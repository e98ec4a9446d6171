// Finds the points near a point, on a torus across its seams too.
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
    // The points must lie in the domain, its upper edges included, and outlive this.
    Neighbours(std::span<const Point> points, const Domain& domain, Poll poll = nobody_asks);
    ~Neighbours();
    Neighbours(const Neighbours&) = delete;
    Neighbours& operator=(const Neighbours&) = delete;

    std::span<const Point> points() const { return points_; }
    const Domain& domain() const { return domain_; }

    struct Neighbour {
        std::size_t index;
        double dx;  // to it, by the shortest way
        double dy;
        double distance;
    };
    // The nearest `count` other points, nearest first; fewer where there are not so many.
    std::vector<Neighbour> nearest(std::size_t index, std::size_t count) const;

    // How many pairs are [i, i + 1) * width apart, for each i below `bins`. Their reach, bins *
    // width, must not be over half the shorter side of a torus.
    std::vector<std::uint64_t> count_pairs(double width, std::size_t bins) const;

    // How many pairs are closer than `distance`, which has the same bound.
    std::uint64_t pairs_closer_than(double distance) const { return count_pairs(distance, 1)[0]; }

    // Calls work(index) for all points, in parallel; the calling thread polls now and then.
    template <typename Work>
    void for_each_point(Work work) const {
        constexpr std::size_t kPointsPerPoll = 4096;  // of some 5 microseconds each
        for (std::size_t begin = 0; begin < points_.size(); begin += kPointsPerPoll) {
            poll_();
            tbb::parallel_for(begin, std::min(begin + kPointsPerPoll, points_.size()), work);
        }
    }

private:
    class Tree;

    // The distinct other points among the nearest `places` of all points and their images.
    std::vector<Neighbour> among_nearest(std::size_t index, std::size_t places) const;

    // Where the point and those of its images are that can have neighbours within `reach`.
    std::vector<Point> images(Point point, double reach) const;

    std::span<const Point> points_;
    Domain domain_;
    Poll poll_;
    std::unique_ptr<Tree> tree_;
};

}  // namespace lacuna::analysis
