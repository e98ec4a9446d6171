// Rings in Clipper's whole numbers.
#include "domains/clip.h"

#include <algorithm>
#include <cmath>

#include "base/polling.h"

namespace lacuna::domains {

int exponent_for(double largest) {
    constexpr int kBits = 52;
    int exponent = 0;
    std::frexp(largest, &exponent);
    return kBits - exponent;
}

double largest_of(std::span<const PolygonRing> rings) {
    double largest = 0;
    for (const PolygonRing& ring : rings)
        for (const Point& point : ring)
            largest = std::max({largest, std::abs(point.x), std::abs(point.y)});
    return largest;
}

Path whole_path(const PolygonRing& ring, int exponent) {
    const auto whole = [exponent](double value) {
        return std::llrint(std::ldexp(value, exponent));
    };
    Path path;
    ask_after(ring.size());
    path.reserve(ring.size());
    for (const Point& point : ring) path.emplace_back(whole(point.x), whole(point.y));
    return path;
}

PolygonRing ring_of(const Path& path, int exponent) {
    PolygonRing ring;
    ask_after(path.size());
    ring.reserve(path.size());
    for (const auto& [x, y] : path)
        ring.push_back({std::ldexp(static_cast<double>(x), -exponent),
                        std::ldexp(static_cast<double>(y), -exponent)});
    return ring;
}

Paths united(const Paths& paths, ClipperLib::PolyFillType fill) {
    ask();
    ClipperLib::Clipper clipper;
    clipper.AddPaths(paths, ClipperLib::ptSubject, true);
    Paths all;
    clipper.Execute(ClipperLib::ctUnion, all, fill, fill);
    return all;
}

void Box::add(const Path& path) {
    for (const auto& [x, y] : path) {
        low = {std::min(low.X, x), std::min(low.Y, y)};
        high = {std::max(high.X, x), std::max(high.Y, y)};
    }
}

}  // namespace lacuna::domains
