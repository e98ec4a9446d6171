// Goes down the tree of pixels, and below a pixel by halves of its lattice points, always to the
// nearest part first.
#include "relax/cpu/nearest_point.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <tuple>

#include "base/insertion_sort.h"

namespace lacuna::relaxing::cpu {
namespace {

// Lattice points [first, last] of an axis.
struct Points {
    std::uint32_t first;
    std::uint32_t last;
};

std::uint64_t square(std::int64_t length) {
    return static_cast<std::uint64_t>(length * length);
}

class Search {
public:
    Search(const Scene& scene, const PixelTree& pixels, std::uint32_t site, bool must_be_assigned,
           const Site& from)
        : scene_(scene),
          numbers_(scene.lattice.numbers),
          pixels_(pixels),
          site_(site),
          must_be_assigned_(must_be_assigned),
          from_(from) {}

    Site run() {
        const std::int64_t images = numbers_.period_x != 0 ? 1 : 0;
        for (const std::int64_t x : {std::int64_t{0}, -images, images}) {
            for (const std::int64_t y : {std::int64_t{0}, -images, images}) {
                x_ = from_.x + x * numbers_.period_x;
                y_ = from_.y + y * numbers_.period_y;
                search(area_of(pixels_.levels() - 1, 0, 0));
                if (images == 0) break;
            }
            if (images == 0) break;
        }
        return {portable::lattice_place(best_column_, numbers_.step_x),
                portable::lattice_place(best_row_, numbers_.step_y), from_.weight};
    }

private:
    // A square of pixels, or a part of a pixel, and the squared distance to its lattice points.
    struct Area {
        Points columns;
        Points rows;
        std::uint64_t distance;
        unsigned level = 0;
        std::uint32_t column = 0;  // of the square
        std::uint32_t row = 0;
    };

    static std::uint64_t distance_to(Points points, std::uint32_t step, std::int64_t at) {
        const std::int64_t first = portable::lattice_place(points.first, step);
        const std::int64_t last = portable::lattice_place(points.last, step);
        return square(at <= first ? first - at : at >= last ? at - last : 0);
    }
    std::uint64_t distance_to(Points columns, Points rows) const {
        return distance_to(columns, numbers_.step_x, x_) + distance_to(rows, numbers_.step_y, y_);
    }

    static Points points_of(unsigned level, std::uint32_t index, std::uint32_t cut,
                            std::uint32_t count) {
        return {(index << level) * cut, std::min(((index + 1) << level) * cut, count) - 1};
    }
    Area area_of(unsigned level, std::uint32_t column, std::uint32_t row) const {
        const Points columns = points_of(level, column, numbers_.cut_x, numbers_.columns);
        const Points rows = points_of(level, row, numbers_.cut_y, numbers_.rows);
        return {columns, rows, distance_to(columns, rows), level, column, row};
    }

    void search(const Area& area) {
        if (area.distance > least_) return;
        if (!pixels_.has_importance(area.level, area.column, area.row)) return;
        if (area.level == 0) return search_points(area.columns, area.rows);
        std::array<Area, 4> parts;
        std::size_t count = 0;
        const unsigned level = area.level - 1;
        for (std::uint32_t row = 2 * area.row; row < 2 * area.row + 2; ++row)
            for (std::uint32_t column = 2 * area.column; column < 2 * area.column + 2; ++column)
                if (row << level < pixels_.rows() && column << level < numbers_.pixel_columns)
                    parts[count++] = area_of(level, column, row);
        insertion_sort(std::span(parts).first(count),
                       [](const Area& a, const Area& b) { return a.distance < b.distance; });
        for (const Area& part : std::span(parts).first(count)) search(part);
    }

    // The lattice points of a pixel, which all have importance.
    void search_points(Points columns, Points rows) {
        const std::uint64_t distance = distance_to(columns, rows);
        if (distance > least_) return;
        const std::uint32_t width = columns.last - columns.first;
        const std::uint32_t height = rows.last - rows.first;
        if (width == 0 && height == 0) return look_at(columns.first, rows.first, distance);
        Points low = width >= height ? columns : rows;
        Points high = low;
        low.last = low.first + (low.last - low.first) / 2;
        high.first = low.last + 1;
        const bool is_across = width >= height;
        const std::uint32_t step = is_across ? numbers_.step_x : numbers_.step_y;
        const std::int64_t at = is_across ? x_ : y_;
        if (distance_to(high, step, at) < distance_to(low, step, at)) std::swap(low, high);
        for (const Points part : {low, high})
            is_across ? search_points(part, rows) : search_points(columns, part);
    }

    void look_at(std::uint32_t column, std::uint32_t row, std::uint64_t distance) {
        if (std::tie(distance, row, column) >= std::tie(least_, best_row_, best_column_)) return;
        if (must_be_assigned_ && !owns(column, row)) return;
        least_ = distance;
        best_row_ = row;
        best_column_ = column;
    }

    std::uint64_t power(std::uint32_t column, std::uint32_t row, const Site& site) const {
        return portable::power_of(portable::lattice_place(column, numbers_.step_x),
                                  portable::lattice_place(row, numbers_.step_y), site.x, site.y,
                                  site.weight, numbers_.period_x, numbers_.period_y);
    }

    // Whether no other site has less power there, or equal power and a lower index.
    bool owns(std::uint32_t column, std::uint32_t row) const {
        const std::uint64_t own = power(column, row, scene_.sites[site_]);
        const std::int64_t px = portable::lattice_place(column, numbers_.step_x);
        const std::int64_t py = portable::lattice_place(row, numbers_.step_y);
        bool is_owner = true;
        const int most = numbers_.period_x != 0 ? 1 : 0;
        for (int shift_x = -most; shift_x <= most; ++shift_x) {
            for (int shift_y = -most; shift_y <= most; ++shift_y) {
                const std::int64_t x = px - std::int64_t{shift_x} * numbers_.period_x;
                const std::int64_t y = py - std::int64_t{shift_y} * numbers_.period_y;
                scene_.tree.find({x, x, y, y}, own, [&](std::uint32_t other) {
                    const std::uint64_t others = power(column, row, scene_.sites[other]);
                    if (others < own ||
                        (others == own && scene_.indices[other] < scene_.indices[site_]))
                        is_owner = false;
                });
            }
        }
        return is_owner;
    }

    const Scene& scene_;
    const portable::RelaxLattice& numbers_;
    const PixelTree& pixels_;
    std::uint32_t site_;
    bool must_be_assigned_;
    Site from_;
    std::int64_t x_ = 0;  // the position, or an image of it
    std::int64_t y_ = 0;
    std::uint64_t least_ = std::numeric_limits<std::uint64_t>::max();
    std::uint32_t best_row_ = 0;
    std::uint32_t best_column_ = 0;
};

std::vector<std::uint8_t> importance_of(const Lattice& lattice) {
    std::vector<std::uint8_t> all(lattice.masses.size());
    std::transform(lattice.masses.begin(), lattice.masses.end(), all.begin(),
                   [](std::uint32_t mass) { return static_cast<std::uint8_t>(mass != 0); });
    return all;
}

}  // namespace

PixelTree::PixelTree(const Lattice& lattice, const Poll& poll)
    : rows_(static_cast<std::uint32_t>(lattice.masses.size() / lattice.numbers.pixel_columns)),
      squares_(rows_, lattice.numbers.pixel_columns, importance_of(lattice), poll) {}

Site nearest_point(const Scene& scene, const PixelTree& pixels, std::uint32_t site,
                   bool must_be_assigned, Site from) {
    return Search(scene, pixels, site, must_be_assigned, from).run();
}

}  // namespace lacuna::relaxing::cpu
