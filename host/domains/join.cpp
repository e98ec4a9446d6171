// Joins polygons with the library Clipper, which cuts in whole numbers (Vatti 1992, "A Generic
// Solution to Polygon Clipping"). Its time is the product of the number of edges and of how many of
// them lie side by side, so the polygons are joined half by half, and only where the halves meet.
#include "domains/join.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <utility>

#include "domains/clip.h"

namespace lacuna::domains {
namespace {

Box box_around(const Paths& paths) {
    Box box;
    for (const Path& path : paths) box.add(path);
    return box;
}

// Sorts the rings by whether they touch the box. A hole may lie apart from it although the ring
// around it does not; then nothing changes near the hole.
void share_out(Paths& paths, const Box& box, Paths& touching, Paths& apart) {
    for (Path& path : paths) {
        Box own;
        own.add(path);
        (own.touches(box) ? touching : apart).push_back(std::move(path));
    }
}

struct Part {
    Paths paths;
    Box box;
};

Paths join(std::span<Part> parts) {
    if (parts.empty()) return {};
    if (parts.size() == 1) return std::move(parts.front().paths);
    Box middles;
    const auto middle_of = [](const Box& box) {
        return ClipperLib::IntPoint(box.low.X / 2 + box.high.X / 2, box.low.Y / 2 + box.high.Y / 2);
    };
    for (const Part& part : parts) middles.add({middle_of(part.box)});
    const bool is_wide = middles.high.X - middles.low.X >= middles.high.Y - middles.low.Y;
    const std::size_t half = parts.size() / 2;
    std::nth_element(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(half), parts.end(),
                     [&](const Part& a, const Part& b) {
                         return is_wide ? middle_of(a.box).X < middle_of(b.box).X
                                        : middle_of(a.box).Y < middle_of(b.box).Y;
                     });
    Paths a = join(parts.first(half));
    Paths b = join(parts.subspan(half));
    const Box around_a = box_around(a);
    const Box around_b = box_around(b);
    Paths touching;
    Paths all;
    share_out(a, around_b, touching, all);
    share_out(b, around_a, touching, all);
    Paths met = united(touching, ClipperLib::pftNonZero);
    std::move(met.begin(), met.end(), std::back_inserter(all));
    return all;
}

}  // namespace

std::vector<PolygonRing> join(std::vector<Polygon> polygons) {
    if (polygons.size() == 1 && polygons.front().fill == Fill::even_odd)
        return std::move(polygons.front().rings);
    double largest = 0;
    for (const Polygon& polygon : polygons) largest = std::max(largest, largest_of(polygon.rings));
    const int exponent = exponent_for(largest);
    std::vector<Part> parts;
    parts.reserve(polygons.size());
    for (const Polygon& polygon : polygons) {
        Paths paths;
        for (const PolygonRing& ring : polygon.rings) paths.push_back(whole_path(ring, exponent));
        paths = united(
            paths, polygon.fill == Fill::nonzero ? ClipperLib::pftNonZero : ClipperLib::pftEvenOdd);
        if (!paths.empty()) parts.push_back({std::move(paths), {}});
    }
    for (Part& part : parts) part.box = box_around(part.paths);
    const Paths all = join(std::span(parts));
    std::vector<PolygonRing> rings;
    rings.reserve(all.size());
    for (const Path& path : all) rings.push_back(ring_of(path, exponent));
    return rings;
}

}  // namespace lacuna::domains
