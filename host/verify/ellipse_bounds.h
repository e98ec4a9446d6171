// Bounds of how far the spots of a cell are over their limits, for samples with ellipses.
//
// A spot is over its limit by the larger of two numbers (Ellipse::over), one for the ellipse of the
// sample and one for the ellipse of the spot. Each is the length of an offset in a squeezed plane,
// less a constant. Such a length is a convex function of the spot, so it is largest at a corner of
// the cell. At each spot it is at least what it is at the centre, less the length of half a
// diagonal. This serves for the ellipse of the spots if the cell lies on one pixel. If it lies on
// several, circles serve, which lie in all of their ellipses or hold all of them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "verify/bounds.h"
#include "verify/ellipse.h"

namespace lacuna::verify {

// Bounds by circles. They need only the distance of a sample, whatever its direction.
class CircleBounds {
public:
    CircleBounds(const Frame& frame, const Under& under)
        : frame_(frame),
          least_(under.radii.least),
          most_(under.radii.most),
          stretch_(under.radii.most / under.radii.least) {}

    // As in Bounds<Disk>. The squeezed length of an offset is at most its length, and at least its
    // length times the squeeze.
    void lower_to_most_over(const Ellipse& ellipse, double& over) const {
        const double farthest = std::sqrt(frame_.to_farthest(ellipse.at));
        over = std::min(over, farthest - std::min(ellipse.shape->shorter, least_));
    }
    bool may_matter(const Ellipse& ellipse, double over) const {
        const double allowed = std::max(over, 0.0);
        const double of_sample = ellipse.shape->longer + allowed / ellipse.shape->squeeze;
        const double of_spots = most_ + allowed * stretch_;
        return frame_.to_nearest(ellipse.at) <= square(std::min(of_sample, of_spots));
    }

private:
    const Frame frame_;
    double least_;
    double most_;
    double stretch_;  // at least that of any ellipse under the cell
};

template <>
class Bounds<Ellipse> {
public:
    Bounds(const Frame& frame, const Under& under)
        : frame_(frame), circles_(frame, under), least_(under.radii.least), shape_(under.shape) {}

    void lower_to_most_over(const Ellipse& ellipse, double& over) const {
        over = std::min(over, most_over(ellipse));
    }
    bool is_at_most(const Ellipse& ellipse, double over) const {
        return most_over(ellipse) <= over;
    }
    bool may_matter(const Ellipse& ellipse, double over) const {
        if (!circles_.may_matter(ellipse, over)) return false;
        const double allowed = std::max(over, 0.0);
        return least_over(ellipse, *ellipse.shape) <= allowed &&
               (shape_ == nullptr || least_over(ellipse, *shape_) <= allowed);
    }

    // Squared distances in the squeezed planes, first that of the sample, then that of the spots.
    bool can_thin_out() const { return shape_ != nullptr; }
    std::array<double, 8> to_corners(const Cell& cell, const Ellipse& ellipse) const {
        std::array<double, 8> squares;
        std::size_t k = 0;
        for (const EllipseShape* shape : {ellipse.shape, shape_})
            for (const double x : {cell.left, cell.right})
                for (const double y : {cell.bottom, cell.top})
                    squares[k++] = squared(shape->squeezed({x - ellipse.at.x, y - ellipse.at.y}));
        return squares;
    }
    // At each corner how far it is over the sample's ellipse, over its own, and over the limit.
    std::array<double, 12> scores(const std::array<double, 8>& squares,
                                  const Ellipse& ellipse) const {
        std::array<double, 12> scores;
        for (std::size_t k = 0; k < 4; ++k) {
            scores[k] = std::sqrt(squares[k]) - ellipse.shape->shorter;
            scores[k + 4] = std::sqrt(squares[k + 4]) - shape_->shorter;
            scores[k + 8] = std::max(scores[k], scores[k + 4]);
        }
        return scores;
    }
    static bool covers_as_much(const Ellipse& other, const Ellipse& ellipse) {
        return other.shape == ellipse.shape;
    }

private:
    static double squared(Point way) { return square(way.x) + square(way.y); }

    Point to_centre(const Ellipse& ellipse) const {
        return {frame_.centre.x - ellipse.at.x, frame_.centre.y - ellipse.at.y};
    }
    double most_over(const Ellipse& ellipse) const {
        const double of_sample = most_over(ellipse, *ellipse.shape);
        if (shape_ != nullptr) return std::max(of_sample, most_over(ellipse, *shape_));
        return std::max(of_sample, std::sqrt(frame_.to_farthest(ellipse.at)) - least_);
    }
    // The squared length of a + b, or of a - b if that is longer, is a^2 + b^2 + 2 |a b|.
    double most_over(const Ellipse& ellipse, const EllipseShape& shape) const {
        const Point middle = shape.squeezed(to_centre(ellipse));
        const Point up = shape.squeezed({frame_.half_width, frame_.half_height});
        const Point down = shape.squeezed({frame_.half_width, -frame_.half_height});
        const auto more = [&](Point half) {
            return squared(half) + 2 * std::abs(middle.x * half.x + middle.y * half.y);
        };
        return std::sqrt(squared(middle) + std::max(more(up), more(down))) - shape.shorter;
    }
    double least_over(const Ellipse& ellipse, const EllipseShape& shape) const {
        const double half = std::max(shape.length_of({frame_.half_width, frame_.half_height}),
                                     shape.length_of({frame_.half_width, -frame_.half_height}));
        return shape.over(to_centre(ellipse)) - half;
    }

    const Frame frame_;
    CircleBounds circles_;
    double least_;
    const EllipseShape* shape_;  // of all spots; null: the cell lies on several pixels
};

}  // namespace lacuna::verify
