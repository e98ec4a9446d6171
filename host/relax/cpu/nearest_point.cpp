// Searches ring after ring of lattice points around a position.
#include "relax/cpu/nearest_point.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace lacuna::relaxing::cpu {
namespace {

constexpr std::uint64_t kFarther = std::numeric_limits<std::uint64_t>::max();

class Search {
public:
    Search(const Scene& scene, std::uint32_t site, bool must_be_assigned, const Site& from)
        : scene_(scene),
          numbers_(scene.lattice.numbers),
          site_(site),
          must_be_assigned_(must_be_assigned),
          from_(from) {}

    Site run() {
        const std::int64_t column = from_.x / numbers_.step_x;
        const std::int64_t row = from_.y / numbers_.step_y;
        // All points of ring i are at least this far away: the position is at most half a step off.
        const std::uint64_t step = std::min(numbers_.step_x, numbers_.step_y);
        const auto last = static_cast<std::int64_t>(std::max(numbers_.columns, numbers_.rows));
        for (std::int64_t ring = 0; ring <= last; ++ring) {
            const auto steps = static_cast<std::uint64_t>(std::max<std::int64_t>(ring - 1, 0));
            if (steps * step * (steps * step) > least_) break;
            for (std::int64_t x = column - ring; x <= column + ring; ++x) {
                look_at(x, row - ring);
                look_at(x, row + ring);
            }
            for (std::int64_t y = row - ring + 1; y < row + ring; ++y) {
                look_at(column - ring, y);
                look_at(column + ring, y);
            }
        }
        return {portable::lattice_place(best_column_, numbers_.step_x),
                portable::lattice_place(best_row_, numbers_.step_y), from_.weight};
    }

private:
    // The index on the lattice. If it is outside and the axis wraps, its image; otherwise -1.
    static std::int64_t wrapped(std::int64_t index, std::uint32_t count, bool wraps) {
        if (index >= 0 && index < count) return index;
        return wraps ? ((index % count) + count) % count : -1;
    }

    void look_at(std::int64_t x, std::int64_t y) {
        x = wrapped(x, numbers_.columns, numbers_.period_x != 0);
        y = wrapped(y, numbers_.rows, numbers_.period_y != 0);
        if (x < 0 || y < 0) return;
        const auto column = static_cast<std::uint32_t>(x);
        const auto row = static_cast<std::uint32_t>(y);
        if (scene_.lattice.mass_at(column, row) == 0) return;
        const std::uint64_t distance = power(column, row, {from_.x, from_.y, 0});
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
    std::uint32_t site_;
    bool must_be_assigned_;
    Site from_;
    std::uint64_t least_ = kFarther;
    std::uint32_t best_row_ = 0;
    std::uint32_t best_column_ = 0;
};

}  // namespace

Site nearest_point(const Scene& scene, std::uint32_t site, bool must_be_assigned, Site from) {
    return Search(scene, site, must_be_assigned, from).run();
}

}  // namespace lacuna::relaxing::cpu
