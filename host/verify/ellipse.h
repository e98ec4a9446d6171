// Ellipses in place of disks, where a field stretches its pixels.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace lacuna::verify {

// The ellipse of a pixel. If the plane is squeezed along the longer radius, by the ratio of the two
// radii, then the ellipse becomes a circle of the shorter radius.
struct EllipseShape {
    double longer;
    double shorter;
    double cosine;  // of the angle from the x axis to the longer radius
    double sine;
    double squeeze;  // shorter / longer

    // An offset in the squeezed plane, turned so that the longer radius lies along x.
    Point squeezed(Point way) const {
        return {(cosine * way.x + sine * way.y) * squeeze, cosine * way.y - sine * way.x};
    }
    // How long an offset is in the squeezed plane: at most as long as it is. The ellipse holds the
    // offset if this is less than the shorter radius.
    double length_of(Point way) const {
        const Point there = squeezed(way);
        return std::sqrt(there.x * there.x + there.y * there.y);
    }
    // The direction in which length_of grows fastest.
    Point slope(Point way) const {
        const Point there = squeezed(way);
        const double along = there.x * squeeze;
        return {along * cosine - there.y * sine, along * sine + there.y * cosine};
    }
    // How far an offset is outside of the ellipse, in the squeezed plane; negative inside.
    double over(Point way) const { return length_of(way) - shorter; }
    // The ellipse's radius in the direction of an offset.
    double radius_along(Point way) const {
        const double length = length_of(way);
        if (length == 0) return shorter;
        return std::sqrt(way.x * way.x + way.y * way.y) * (shorter / length);
    }
};

// The ellipse that has the area of a disk of this radius.
inline EllipseShape shape_from(double radius, const Stretch& stretch) {
    const double root = std::sqrt(stretch.ratio);
    return {radius * root, radius / root, std::cos(stretch.angle), std::sin(stretch.angle),
            1 / stretch.ratio};
}

// A sample and its ellipse. It covers a spot if each lies in the other's ellipse.
struct Ellipse {
    Point at;
    const EllipseShape* shape;

    // How far the spot is from being covered: in the squeezed plane of this ellipse or of its own,
    // whichever is more. With circles this is the distance over the smaller radius.
    double over(Point spot, const EllipseShape& of_spot) const {
        const Point way{spot.x - at.x, spot.y - at.y};
        return std::max(shape->over(way), of_spot.over(way));
    }
};

// A sample near a border of pixels may have any ellipse of these pixels. Two samples are too close
// only if they are with all ellipses that they may have.
struct BlurredEllipse {
    Point at;
    double radius;  // the least of the longer radii: what is farther away is not too close
    std::span<const EllipseShape* const> shapes;  // at least one
};

}  // namespace lacuna::verify
