// Finds near dots with nanoflann.
#include "stipple/pen/neighbours.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <nanoflann.hpp>

#include "base/threads.h"

namespace lacuna::pen {
namespace {

// The interface that nanoflann expects of what it finds: all spots within a distance.
struct Within {
    using DistanceType = double;
    using IndexType = std::uint32_t;

    double squared_distance;
    std::vector<std::uint32_t> spots{};

    // NOLINTBEGIN(readability-identifier-naming): its names
    double worstDist() const { return squared_distance; }
    bool addPoint(double squared, std::uint32_t index) {
        if (squared < squared_distance) spots.push_back(index);
        return true;
    }
    // NOLINTEND(readability-identifier-naming)
    bool full() const { return true; }
    bool empty() const { return spots.empty(); }
    std::size_t size() const { return spots.size(); }
    void sort() {}
};

}  // namespace

struct Neighbours::Index {
    // The interface that nanoflann expects of a set of points. Its doubles hold the whole numbers
    // of the spots, and the squares of their distances, exactly.
    struct Cloud {
        std::span<const Spot> spots;

        std::size_t kdtree_get_point_count() const { return spots.size(); }
        double kdtree_get_pt(std::size_t index, std::size_t axis) const {
            return static_cast<double>(axis == 0 ? spots[index].x : spots[index].y);
        }
        template <class Box>
        bool kdtree_get_bbox(Box&) const {
            return false;
        }
    };
    using Metric = nanoflann::L2_Simple_Adaptor<double, Cloud>;
    using Tree = nanoflann::KDTreeSingleIndexAdaptor<Metric, Cloud, 2, std::uint32_t>;

    explicit Index(std::span<const Spot> spots) : cloud{spots}, tree(2, cloud) {}

    std::array<double, 2> at(std::size_t spot) const {
        return {cloud.kdtree_get_pt(spot, 0), cloud.kdtree_get_pt(spot, 1)};
    }

    Cloud cloud;
    Tree tree;
};

Neighbours::Neighbours(std::span<const Spot> spots, std::size_t most)
    : index_(std::make_unique<Index>(spots)),
      each_(std::min(most, spots.size() - std::min<std::size_t>(spots.size(), 1))),
      all_(each_ * spots.size()) {
    if (each_ == 0) return;
    const auto find = [&](const tbb::blocked_range<std::size_t>& range) {
        std::vector<std::uint32_t> found(each_ + 1);
        std::vector<double> distances(each_ + 1);
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            index_->tree.knnSearch(index_->at(i).data(), found.size(), found.data(),
                                   distances.data());
            // Removes the spot itself. If many dots lie on one spot, it may not be in the list.
            const auto self = std::find(found.begin(), found.end() - 1, i);
            std::rotate(self, self + 1, found.end());
            std::copy_n(found.begin(), each_, &all_[i * each_]);
        }
    };
    make_sure_of_threads();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, spots.size(), 4096), find);
}

Neighbours::~Neighbours() = default;

std::vector<std::uint32_t> Neighbours::nearer(std::size_t spot,
                                              std::int64_t squared_distance) const {
    Within found{static_cast<double>(squared_distance)};
    index_->tree.findNeighbors(found, index_->at(spot).data(), {});
    return std::move(found.spots);
}

}  // namespace lacuna::pen
