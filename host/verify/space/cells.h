// Parts of surfaces and volumes: triangles and boxes in space. Both are convex, so that all of a
// part lies within a ball if its corners do.
#pragma once

#include <lacuna/space.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lacuna::verify::space {

inline Point3 operator+(const Point3& a, const Point3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Point3 operator-(const Point3& a, const Point3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Point3 operator*(double factor, const Point3& a) {
    return {factor * a.x, factor * a.y, factor * a.z};
}
inline double dot(const Point3& a, const Point3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Point3 cross(const Point3& a, const Point3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double distance_of(const Point3& a, const Point3& b) {
    return std::sqrt(dot(a - b, a - b));
}
// The distance of a point and the line from a to b.
inline double distance_to_line(const Point3& at, const Point3& a, const Point3& b) {
    const Point3 way = b - a;
    const double length = dot(way, way);
    const double share = length > 0 ? std::clamp(dot(at - a, way) / length, 0.0, 1.0) : 0;
    return distance_of(at, a + share * way);
}

struct TriangleCell {
    std::array<Point3, 3> corners;

    Point3 centre() const { return (1.0 / 3) * (corners[0] + corners[1] + corners[2]); }
    double radius() const { return farthest(centre()); }
    // The distance of a point and the corner that is farthest from it.
    double farthest(const Point3& from) const {
        double most = 0;
        for (const Point3& corner : corners) most = std::max(most, distance_of(from, corner));
        return most;
    }
    double distance_to(const Point3& at) const {
        const auto& [a, b, c] = corners;
        const double to_edges = std::min(
            {distance_to_line(at, a, b), distance_to_line(at, b, c), distance_to_line(at, c, a)});
        // Seen along the normal, the point is inside if it is on one side of all edges. Of a thin
        // triangle, products of the sides' lengths would lose the digits that the normal has.
        const Point3 normal = cross(b - a, c - a);
        const double length = distance_of(normal, {});
        const auto is_outside = [&](const Point3& from, const Point3& to) {
            return dot(cross(to - from, at - from), normal) < 0;
        };
        if (!(length > 0) || is_outside(a, b) || is_outside(b, c) || is_outside(c, a))
            return to_edges;
        return std::min(to_edges, std::abs(dot(at - a, normal)) / length);
    }
    std::array<TriangleCell, 4> parts() const {
        const auto& [a, b, c] = corners;
        const Point3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
        return {{{{a, ab, ca}}, {{ab, b, bc}}, {{ca, bc, c}}, {{bc, ca, ab}}}};
    }
};

struct BoxCell {
    Point3 low;
    Point3 high;

    void add(const Point3& point) {
        low = {std::min(low.x, point.x), std::min(low.y, point.y), std::min(low.z, point.z)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y), std::max(high.z, point.z)};
    }
    bool has(const Point3& p) const { return distance_to(p) == 0; }
    bool has_below(const Point3& p) const {
        return has(p) && p.x < high.x && p.y < high.y && p.z < high.z;
    }
    double longest_side() const {
        return std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    }
    Point3 centre() const { return 0.5 * (low + high); }
    double radius() const { return distance_of(low, high) / 2; }
    double farthest(const Point3& from) const {
        const auto along = [](double at, double least, double most) {
            return std::max(std::abs(at - least), std::abs(at - most));
        };
        const Point3 way{along(from.x, low.x, high.x), along(from.y, low.y, high.y),
                         along(from.z, low.z, high.z)};
        return std::sqrt(dot(way, way));
    }
    double distance_to(const Point3& at) const {
        return distance_of(at, {std::clamp(at.x, low.x, high.x), std::clamp(at.y, low.y, high.y),
                                std::clamp(at.z, low.z, high.z)});
    }
    std::array<BoxCell, 8> parts() const {
        const Point3 middle = centre();
        std::array<BoxCell, 8> parts;
        for (unsigned i = 0; i < 8; ++i) {
            const bool x = (i & 1U) != 0, y = (i & 2U) != 0, z = (i & 4U) != 0;
            parts[i] = {{x ? middle.x : low.x, y ? middle.y : low.y, z ? middle.z : low.z},
                        {x ? high.x : middle.x, y ? high.y : middle.y, z ? high.z : middle.z}};
        }
        return parts;
    }
};

}  // namespace lacuna::verify::space
