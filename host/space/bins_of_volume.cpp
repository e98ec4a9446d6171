// Cuts a volume into its first bins, and converts positions to units.
#include "space/first_bins.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lacuna::space {
namespace {

std::uint32_t cells_along(std::int32_t side, std::uint64_t radius) {
    return static_cast<std::uint32_t>(
        std::max<std::uint64_t>(1, static_cast<std::uint64_t>(side) / radius));
}

}  // namespace

Position Units::position_of(const Point3& point) const {
    const auto along = [](double way, double unit_along) {
        return static_cast<std::int32_t>(std::llround(way / unit_along));
    };
    return {along(point.x - low.x, unit.x), along(point.y - low.y, unit.y),
            along(point.z - low.z, unit.z)};
}

FirstBins bins_of_volume(std::array<std::int32_t, 3> sides, bool wraps, std::uint64_t radius,
                         std::span<const Position> kept) {
    FirstBins made{.sides = sides, .wraps = wraps};
    for (std::size_t axis = 0; axis < 3; ++axis)
        made.cells[axis] = cells_along(sides[axis], radius);
    const std::size_t blocks = std::size_t{made.cells[0]} * made.cells[1] * made.cells[2];
    made.bins.assign(blocks, Portion{0, 0, 0, 0});
    made.begins.resize(blocks + 1);
    for (std::size_t i = 0; i <= blocks; ++i) made.begins[i] = static_cast<std::uint32_t>(i);
    // The block of a kept sample: the last cell that begins at or before it.
    const auto along = [&](std::size_t axis, std::int64_t at) {
        const std::int64_t count = made.cells[axis];
        auto cell = std::min(at * count / sides[axis], count - 1);
        while (cell + 1 < count && sides[axis] * (cell + 1) / count <= at) ++cell;
        return static_cast<std::uint32_t>(cell);
    };
    std::vector<std::pair<std::uint64_t, std::uint32_t>> places;  // block and number
    for (const Position& position : kept)
        places.emplace_back(
            (std::uint64_t{along(2, position.z)} * made.cells[1] + along(1, position.y)) *
                    made.cells[0] +
                along(0, position.x),
            static_cast<std::uint32_t>(places.size()));
    std::sort(places.begin(), places.end());
    made.kept_begins.assign(blocks + 1, 0);
    for (const auto& [key, index] : places) {
        made.kept.push_back(kept[index]);
        ++made.kept_begins[key + 1];
    }
    for (std::size_t i = 0; i < blocks; ++i) made.kept_begins[i + 1] += made.kept_begins[i];
    return made;
}

}  // namespace lacuna::space
