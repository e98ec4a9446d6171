// Finds nearest dots with nanoflann.
#include "drawing/pen/neighbours.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <nanoflann.hpp>

#include "base/threads.h"

namespace lacuna::pen {
namespace {

// The interface that nanoflann expects of a set of points. Its doubles hold the whole numbers of
// the spots, and the squares of their distances, exactly.
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

}  // namespace

Neighbours::Neighbours(std::span<const Spot> spots, std::size_t most)
    : each_(std::min(most, spots.size() - std::min<std::size_t>(spots.size(), 1))),
      all_(each_ * spots.size()) {
    if (each_ == 0) return;
    const Cloud cloud{spots};
    const Tree tree(2, cloud);
    const auto find = [&](const tbb::blocked_range<std::size_t>& range) {
        std::vector<std::uint32_t> found(each_ + 1);
        std::vector<double> distances(each_ + 1);
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const std::array<double, 2> at{cloud.kdtree_get_pt(i, 0), cloud.kdtree_get_pt(i, 1)};
            tree.knnSearch(at.data(), found.size(), found.data(), distances.data());
            // Removes the spot itself. If many dots lie on one spot, it may not be in the list.
            const auto self = std::find(found.begin(), found.end() - 1, i);
            std::rotate(self, self + 1, found.end());
            std::copy_n(found.begin(), each_, &all_[i * each_]);
        }
    };
    make_sure_of_threads();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, spots.size(), 4096), find);
}

}  // namespace lacuna::pen
