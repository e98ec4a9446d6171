// Sums chords, and counts lattice points.
#include "reproduce/disk_area.h"

#include <cmath>
#include <numbers>

namespace lacuna::reproduce {
namespace {

// Calls `visit(half chord)` for every line that crosses the disk.
template <class Visit>
void for_each_chord(std::uint32_t m, double offset, const Visit& visit) {
    const double squared_radius = static_cast<double>(m) * m;
    const auto reach = static_cast<std::int64_t>(m) + 1;
    for (std::int64_t line = -reach; line <= reach; ++line) {
        const double distance = static_cast<double>(line) - offset;
        const double rest = squared_radius - distance * distance;
        if (rest > 0) visit(std::sqrt(rest));
    }
}

double disk_area(std::uint32_t m) {
    return std::numbers::pi * static_cast<double>(m) * m;
}

}  // namespace

double area_by_lines(std::uint32_t m, double offset) {
    double area = 0;
    for_each_chord(m, offset, [&](double half) { area += 2 * half; });
    return area / disk_area(m);
}

double area_by_cells(std::uint32_t m, double offset_x, double offset_y) {
    double points = 0;
    for_each_chord(m, offset_x, [&](double half) {
        // The whole numbers in (offset_y - half, offset_y + half).
        points += std::ceil(offset_y + half) - std::floor(offset_y - half) - 1;
    });
    return points / disk_area(m);
}

}  // namespace lacuna::reproduce
