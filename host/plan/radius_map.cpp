// Computes radii from importance, and how far away conflicts can be.
#include "plan/radius_map.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <utility>

#include "portable/metric.h"

namespace lacuna {
namespace {

constexpr std::uint32_t kUnitsPerStep = 256;

// For `count` steps along an axis of `cells` pixels: the pixel under the middle of each step.
std::vector<std::uint32_t> nearest(std::uint32_t count, std::uint32_t cells) {
    std::vector<std::uint32_t> index(count);
    for (std::uint32_t i = 0; i < count; ++i)
        index[i] = static_cast<std::uint32_t>((2 * std::uint64_t{i} + 1) * cells /
                                              (2 * std::uint64_t{count}));
    return index;
}

// The radius in lattice steps, rounded up.
std::uint32_t steps_of(std::uint32_t radius) {
    return radius / kUnitsPerStep + (radius % kUnitsPerStep != 0 ? 1 : 0);
}

}  // namespace

RadiusMap::RadiusMap(const Field& field, double scale, Metric metric, std::uint32_t lines,
                     std::uint32_t height, Step step, bool wraps, const Poll& poll)
    : columns(field.columns),
      rows(field.rows),
      radii(field.importance.size()),
      column_of(nearest(lines, columns)),
      row_of(nearest(height, rows)) {
    // A radius beyond twice the diagonal blocks everything, even averaged with a small one.
    const double most = 2 * (std::hypot(lines, height) + 1);
    const auto radius_of = [&](double importance) -> std::uint32_t {
        if (importance <= 0) return 0;
        // Rounded up by at least 2^-10 of a unit: more than doubles lose when converted back.
        const double steps =
            std::min((scale / std::sqrt(importance) + step.lost) / step.length, most);
        return static_cast<std::uint32_t>(steps * kUnitsPerStep + 1.0 / 1024) + 1;
    };
    // Columns in a tile: the values that are written stay in the cache from row to row.
    constexpr std::uint32_t kTile = 64;
    const auto fill_tile = [&](std::size_t tile) {
        const std::uint32_t first = static_cast<std::uint32_t>(tile) * kTile;
        const std::uint32_t end = std::min(first + kTile, columns);
        for (std::uint32_t row = 0; row < rows; ++row) {
            const double* const line = &field.importance[std::size_t{rows - 1 - row} * columns];
            for (std::uint32_t column = first; column < end; ++column)
                radii[std::size_t{column} * rows + row] = radius_of(line[column]);
        }
    };
    for_each_polled((columns + kTile - 1) / kTile, poll, fill_tile, std::size_t{kTile} * rows);
    row_begins.reserve(rows + std::size_t{1});
    for (std::uint32_t row = 0; row <= rows; ++row)
        row_begins.push_back(static_cast<std::uint32_t>(
            std::lower_bound(row_of.begin(), row_of.end(), row) - row_of.begin()));
    find_reaches(metric, wraps, poll);
    if (metric != Metric::min) find_widest_rows(poll);
}

// With min no conflict is farther than a sample's own radius. With mean and max a larger radius
// nearby reaches farther. So radii are classed by powers of two. Each class has blocks as wide as
// its largest radius: one that reaches a pixel is in the nine blocks around it.
void RadiusMap::find_reaches(Metric metric, bool wraps, const Poll& poll) {
    reaches.resize(radii.size());
    std::uint64_t classes = 0;  // bit i: there are radii of i bits
    for_each_polled(radii.size(), poll, [&](std::size_t i) {
        reaches[i] = steps_of(radii[i]);
        classes |= std::uint64_t{1} << std::bit_width(radii[i]);
    });
    if (metric == Metric::min) return;

    const auto lines = static_cast<double>(column_of.size());
    const auto height = static_cast<double>(row_of.size());
    for (unsigned bits = 1; bits < static_cast<unsigned>(std::bit_width(classes)); ++bits) {
        if ((classes >> bits & 1) == 0) continue;
        // The class of radii below 2^bits; its blocks in pixels.
        const double block_steps = static_cast<double>(std::uint64_t{1} << bits) / kUnitsPerStep;
        const auto side = [&](double pixels, double steps) {
            return static_cast<std::uint32_t>(
                std::clamp(std::ceil(block_steps * pixels / steps) + 1, 1.0, pixels));
        };
        const std::uint32_t width = side(columns, lines);
        const std::uint32_t depth = side(rows, height);
        const std::uint32_t across = (columns + width - 1) / width;
        const std::uint32_t up = (rows + depth - 1) / depth;

        std::vector<std::uint32_t> largest(std::size_t{across} * up, 0);
        const auto gather_column = [&](std::size_t column) {
            for (std::uint32_t row = 0; row < rows; ++row) {
                const std::uint32_t radius = radii[column * rows + row];
                if (static_cast<unsigned>(std::bit_width(radius)) != bits) continue;
                std::uint32_t& block = largest[column / width * up + row / depth];
                block = std::max(block, radius);
            }
        };
        for_each_polled(columns, poll, gather_column, rows);

        // On a torus the last block may be shorter than the others, so one more is searched.
        const std::int64_t around = wraps ? 2 : 1;
        std::vector<std::uint32_t> dilated(largest.size(), 0);
        const auto other = [&](std::int64_t index, std::int64_t count) {
            return wraps ? (index % count + count) % count : index;
        };
        for (std::int64_t i = 0; i < across; ++i) {
            poll();
            for (std::int64_t j = 0; j < up; ++j)
                for (std::int64_t di = -around; di <= around; ++di)
                    for (std::int64_t dj = -around; dj <= around; ++dj) {
                        const std::int64_t from_i = other(i + di, across);
                        const std::int64_t from_j = other(j + dj, up);
                        if (from_i < 0 || from_i >= across || from_j < 0 || from_j >= up) continue;
                        std::uint32_t& to = dilated[static_cast<std::size_t>(i * up + j)];
                        to = std::max(to, largest[static_cast<std::size_t>(from_i * up + from_j)]);
                    }
        }
        const auto widen_column = [&](std::size_t column) {
            for (std::uint32_t row = 0; row < rows; ++row) {
                std::uint32_t& reach = reaches[column * rows + row];
                if (reach == 0) continue;
                reach = std::max(reach, steps_of(dilated[column / width * up + row / depth]));
            }
        };
        for_each_polled(columns, poll, widen_column, rows);
    }
}

// Rows are counted by class, then listed from the widest class down.
void RadiusMap::find_widest_rows(const Poll& poll) {
    widest_rows.resize(radii.size());
    std::array<std::uint32_t, RADIUS_CLASSES> next{};
    const auto list_column = [&](std::size_t column) {
        const std::span<const std::uint32_t> of_column(&radii[column * rows], rows);
        next.fill(0);
        for (const std::uint32_t radius : of_column) ++next[portable::radius_class(radius)];
        auto sum = static_cast<std::uint32_t>(column * rows);
        for (auto it = next.rbegin(); it != next.rend(); ++it) sum += std::exchange(*it, sum);
        for (std::uint32_t row = 0; row < rows; ++row)
            widest_rows[next[portable::radius_class(of_column[row])]++] = row;
    };
    for_each_polled(columns, poll, list_column, rows);
}

}  // namespace lacuna
