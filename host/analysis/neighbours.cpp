// Searches a k-d tree. On a torus it also searches from the images of the point.
#include "analysis/neighbours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>
#include <utility>

#include "analysis/close_pairs.h"

namespace lacuna::analysis {
namespace {

double shortest(double difference, double side, bool torus) {
    return torus ? difference - side * std::nearbyint(difference / side) : difference;
}

}  // namespace

class Neighbours::Tree {
public:
    Tree(std::span<const Point> points, const Poll& poll)
        : cloud_{points, &poll}, index_(2, cloud_) {
        cloud_.poll = nullptr;
    }

    template <class Result>
    void search(Point from, Result& result) const {
        const double position[2] = {from.x, from.y};
        index_.findNeighbors(result, position, {});
    }

private:
    // The interface that nanoflann requires of points.
    struct Cloud {
        std::span<const Point> points;
        const Poll* poll;  // polled on the calling thread while the tree is built, which takes long
        mutable std::size_t looks = 0;

        std::size_t kdtree_get_point_count() const { return points.size(); }
        double kdtree_get_pt(std::size_t index, std::size_t axis) const {
            constexpr std::size_t kLooksPerPoll = 1 << 20;  // takes some milliseconds
            if (poll != nullptr && ++looks % kLooksPerPoll == 0) (*poll)();
            return axis == 0 ? points[index].x : points[index].y;
        }
        template <class Box>
        bool kdtree_get_bbox(Box&) const {
            return false;
        }
    };

    using KdTree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>,
                                                       Cloud, 2, std::size_t>;

    Cloud cloud_;
    KdTree index_;
};

Neighbours::Neighbours(std::span<const Point> points, const Domain& domain, Poll poll)
    : points_(points),
      domain_(domain),
      poll_(std::move(poll)),
      tree_(std::make_unique<Tree>(points, poll_)) {}

Neighbours::~Neighbours() = default;

std::vector<Point> Neighbours::images(Point point, double reach) const {
    std::vector<Point> images{point};
    if (!domain_.torus) return images;
    const auto can_reach = [reach](double at, double side) {
        return at + reach >= 0 && at - reach <= side;
    };
    for (const double i : {-1.0, 0.0, 1.0}) {
        for (const double j : {-1.0, 0.0, 1.0}) {
            const Point image{point.x + i * domain_.width, point.y + j * domain_.height};
            if ((i != 0 || j != 0) && can_reach(image.x, domain_.width) &&
                can_reach(image.y, domain_.height))
                images.push_back(image);
        }
    }
    return images;
}

std::vector<Neighbours::Neighbour> Neighbours::nearest(std::size_t index, std::size_t count) const {
    const std::size_t most = std::min(count, points_.size() - 1);
    // The point itself and second images of its neighbours are found too, and may displace others
    // if points are few or the torus is thin. So the number is doubled until enough are found.
    for (std::size_t places = count + 1;; places *= 2) {
        std::vector<Neighbour> neighbours = among_nearest(index, places);
        if (neighbours.size() < most) continue;
        neighbours.resize(most);
        return neighbours;
    }
}

std::vector<Neighbours::Neighbour> Neighbours::among_nearest(std::size_t index,
                                                             std::size_t places) const {
    std::vector<std::size_t> indices(places);
    std::vector<double> squares(places);
    nanoflann::KNNResultSet<double, std::size_t> found(places);
    found.init(indices.data(), squares.data());
    const Point from = points_[index];
    tree_->search(from, found);
    const double reach =
        found.full() ? std::sqrt(squares.back()) : std::numeric_limits<double>::infinity();
    const std::vector<Point> all = images(from, reach);
    std::for_each(all.begin() + 1, all.end(),
                  [&](const Point& image) { tree_->search(image, found); });

    std::vector<Neighbour> neighbours;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const std::size_t other = indices[i];
        const auto is_other = [other](const Neighbour& known) { return known.index == other; };
        if (other == index || std::any_of(neighbours.begin(), neighbours.end(), is_other)) continue;
        const double dx = shortest(points_[other].x - from.x, domain_.width, domain_.torus);
        const double dy = shortest(points_[other].y - from.y, domain_.height, domain_.torus);
        neighbours.push_back({other, dx, dy, std::sqrt(dx * dx + dy * dy)});
    }
    return neighbours;
}

std::vector<std::uint64_t> Neighbours::count_pairs(double width, std::size_t bins) const {
    return count_close_pairs(points_, domain_, width, bins, poll_);
}

}  // namespace lacuna::analysis
