// From the largest radius to the least, each sample is compared with those before it that are as
// near as the best pair's ratio allows.
//
// Those before it have no smaller radii, so the limit is the sample's own; and they keep at least
// the best ratio of that apart from each other, so only a few are as near. A grid whose cells are
// so wide finds them, and is made anew when what is looked for has become half as wide.
#include "verify/closest_by_limit.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <vector>

namespace lacuna::verify {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

// Samples by cell, in lists that cells share by chance: who looks must compare distances anyway.
class Grid {
public:
    Grid(const Domain& domain, std::span<const Disk> disks)
        : domain_(domain),
          disks_(disks),
          heads_(std::bit_ceil(2 * disks.size() + 1), kNone),
          next_(disks.size()) {}

    // Empties the grid. Whatever is within `reach` of a place is in a cell next to the place's.
    void make_cells_for(double reach) {
        constexpr double kMostCells = 0x1p50;
        const auto cells_along = [&](double side) {
            return std::clamp(std::floor(side / reach * (1 - 1e-9)), 1.0, kMostCells);
        };
        columns_ = cells_along(domain_.width);
        rows_ = cells_along(domain_.height);
        std::fill(heads_.begin(), heads_.end(), kNone);
    }

    void insert(std::uint32_t index) {
        const Point at = disks_[index].at;
        std::uint32_t& head =
            list_of(cell(at.x, domain_.width, columns_), cell(at.y, domain_.height, rows_));
        next_[index] = head;
        head = index;
    }

    template <typename Look>
    void look_around(Point at, Look look) {
        const double column = cell(at.x, domain_.width, columns_);
        const double row = cell(at.y, domain_.height, rows_);
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j)
                for (std::uint32_t index =
                         list_of(wrapped(column + i, columns_), wrapped(row + j, rows_));
                     index != kNone; index = next_[index])
                    look(index);
    }

private:
    // Cells are counted in doubles, which hold 2^50 of them exactly.
    static double cell(double at, double side, double count) {
        return std::min(std::floor(at / side * count), count - 1);
    }
    // On a box this only adds cells.
    static double wrapped(double cell, double count) {
        return cell < 0 ? count - 1 : cell >= count ? 0 : cell;
    }
    std::uint32_t& list_of(double column, double row) {
        const std::uint64_t mixed = static_cast<std::uint64_t>(column) * 0x9e3779b97f4a7c15U +
                                    static_cast<std::uint64_t>(row) * 0xc2b2ae3d27d4eb4fU;
        return heads_[(mixed ^ (mixed >> 32U)) & (heads_.size() - 1)];
    }

    const Domain& domain_;
    std::span<const Disk> disks_;
    double columns_ = 1;
    double rows_ = 1;
    std::vector<std::uint32_t> heads_;
    std::vector<std::uint32_t> next_;
};

class Closest {
public:
    Closest(const Domain& domain, std::span<const Disk> disks, const Patience& patience)
        : domain_(domain), disks_(disks), patience_(patience), grid_(domain, disks) {}

    LimitedPair run() {
        std::vector<std::uint32_t> order(disks_.size());
        std::iota(order.begin(), order.end(), 0U);
        std::sort(order.begin(), order.end(),
                  patience_.looking([&](std::uint32_t a, std::uint32_t b) {
                      return std::tuple(-disks_[a].radius, a) < std::tuple(-disks_[b].radius, b);
                  }));
        for (std::size_t i = 0; i < order.size() && closest_.ratio >= kHopeless; ++i) {
            constexpr std::size_t kSeldom = 1U << 12U;
            if (i % kSeldom == 0) patience_.look();
            fit_grid(std::span(order).first(i), closest_.ratio * disks_[order[i]].radius);
            grid_.look_around(disks_[order[i]].at,
                              [&](std::uint32_t other) { compare(order[i], other); });
            grid_.insert(order[i]);
        }
        return closest_;
    }

private:
    void fit_grid(std::span<const std::uint32_t> before, double reach) {
        if (reach >= reach_ / 2) return;
        reach_ = reach;
        grid_.make_cells_for(reach + 2 * domain_.rounding());
        for (const std::uint32_t index : before) grid_.insert(index);
    }

    void compare(std::uint32_t a, std::uint32_t b) {
        if (a == b) return;
        LimitedPair pair{std::min(a, b), std::max(a, b),
                         domain_.distance(disks_[a].at, disks_[b].at),
                         std::min(disks_[a].radius, disks_[b].radius)};
        pair.ratio = pair.distance / pair.limit;
        if (std::tie(pair.ratio, pair.first, pair.second) <
            std::tie(closest_.ratio, closest_.first, closest_.second))
            closest_ = pair;
    }

    const Domain& domain_;
    std::span<const Disk> disks_;
    const Patience& patience_;
    Grid grid_;
    double reach_ = std::numeric_limits<double>::infinity();
    LimitedPair closest_;
};

}  // namespace

LimitedPair closest_by_limit(const Domain& domain, std::span<const Disk> disks,
                             const Patience& patience) {
    return Closest(domain, disks, patience).run();
}

}  // namespace lacuna::verify
