// A band is a line and everything near to it. Bands are drawn onto a mask one row at a time: each
// covers an interval of the row.
#include "domains/bands.h"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace lacuna::domains {
namespace {

// A line and everything nearer to it than `reach`, in the unit of the domain.
struct Band {
    Point from;
    Point to;
    double reach;
    std::uint32_t first_row;  // of the rows whose middles it may touch, counted from the bottom
    std::uint32_t end_row;
};

struct Interval {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double a, double b) {
        low = std::min({low, a, b});
        high = std::max({high, a, b});
    }
};

// The part of the row at this height that is within reach of the line. The band is convex: two
// disks around the ends, and a rectangle along the line.
Interval reached_of_row(const Band& band, double y) {
    Interval reached;
    for (const Point& end : {band.from, band.to}) {
        const double up = y - end.y;
        const double squared = band.reach * band.reach - up * up;
        if (squared >= 0) reached.add(end.x - std::sqrt(squared), end.x + std::sqrt(squared));
    }
    const double dx = band.to.x - band.from.x;
    const double dy = band.to.y - band.from.y;
    const double length = std::sqrt(dx * dx + dy * dy);
    if (length == 0) return reached;
    // The corners of the rectangle, in order around it; the row crosses its sides.
    const double aside_x = -dy / length * band.reach;
    const double aside_y = dx / length * band.reach;
    const std::array<Point, 4> corners{Point{band.from.x + aside_x, band.from.y + aside_y},
                                       Point{band.to.x + aside_x, band.to.y + aside_y},
                                       Point{band.to.x - aside_x, band.to.y - aside_y},
                                       Point{band.from.x - aside_x, band.from.y - aside_y}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point a = corners[i];
        const Point b = corners[(i + 1) % corners.size()];
        if (std::min(a.y, b.y) > y || std::max(a.y, b.y) < y) continue;
        const double share = a.y == b.y ? 0 : (y - a.y) / (b.y - a.y);
        const double x = a.x + share * (b.x - a.x);
        reached.add(x, a.y == b.y ? b.x : x);
    }
    return reached;
}

}  // namespace

Mask near_rings(std::span<const PolygonRing> rings, double reach, Point scale, Mask near) {
    std::vector<Band> bands;
    for (const PolygonRing& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point from = ring[i];
            const Point to = ring[(i + 1) % ring.size()];
            const double low = std::min(from.y, to.y) - reach;
            const double high = std::max(from.y, to.y) + reach;
            const std::uint32_t first = first_middle_from(low * scale.y, near.rows);
            const std::uint32_t end = first_middle_from(high * scale.y + 1, near.rows);
            if (first < end) bands.push_back({from, to, reach, first, end});
        }
    std::sort(bands.begin(), bands.end(),
              [](const Band& a, const Band& b) { return a.first_row < b.first_row; });
    std::vector<Band> open;
    std::vector<std::int32_t> begins(near.columns +
                                     std::size_t{1});  // bands that begin, minus bands that end
    std::size_t next = 0;
    for (std::uint32_t row = 0; row < near.rows; ++row) {
        std::erase_if(open, [row](const Band& band) { return band.end_row <= row; });
        for (; next < bands.size() && bands[next].first_row == row; ++next)
            open.push_back(bands[next]);
        if (open.empty()) continue;
        std::fill(begins.begin(), begins.end(), 0);
        for (const Band& band : open) {
            const Interval reached = reached_of_row(band, (row + 0.5) / scale.y);
            if (reached.low > reached.high) continue;
            const std::uint32_t first = first_middle_from(reached.low * scale.x, near.columns);
            const double after = std::floor(reached.high * scale.x - 0.5) + 1;
            const auto end = static_cast<std::uint32_t>(
                std::clamp(after, 0.0, static_cast<double>(near.columns)));
            if (first >= end) continue;
            ++begins[first];
            --begins[end];
        }
        std::int32_t depth = 0;
        const std::size_t from_top = std::size_t{near.rows - 1 - row} * near.columns;
        for (std::uint32_t column = 0; column < near.columns; ++column) {
            depth += begins[column];
            near.allowed[from_top + column] = depth > 0 ? 1 : 0;
        }
    }
    return near;
}

}  // namespace lacuna::domains
