// Sites on one spot go to free spots around it.
#include "relax/take_apart.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace lacuna::relaxing {
namespace {

// Offset i of a spiral around (0, 0): ring after ring.
struct Offset {
    std::int64_t x;
    std::int64_t y;
};
Offset spiral(std::uint64_t i) {
    if (i == 0) return {0, 0};
    std::int64_t ring = 1;
    std::int64_t before = 1;  // offsets of smaller rings
    while (before + 8 * ring <= static_cast<std::int64_t>(i)) before += 8 * ring++;
    const std::int64_t along = static_cast<std::int64_t>(i) - before;
    const std::int64_t side = along / (2 * ring);
    const std::int64_t way = along % (2 * ring) - ring;
    if (side == 0) return {way, -ring};
    if (side == 1) return {ring, way};
    if (side == 2) return {-way, ring};
    return {-ring, -way};
}

class Spots {
public:
    Spots(const portable::RelaxLattice& numbers, const std::vector<Site>& sites)
        : width_(std::int64_t{numbers.columns} * numbers.step_x),
          height_(std::int64_t{numbers.rows} * numbers.step_y),
          wraps_(numbers.period_x != 0) {
        for (const Site& site : sites) taken_.insert(key(site.x, site.y));
    }

    void move_away(Site& site) {
        std::uint64_t& next = tried_[key(site.x, site.y)];
        for (;; ++next) {
            const auto [dx, dy] = spiral(next);
            std::int64_t x = site.x + dx;
            std::int64_t y = site.y + dy;
            if (wraps_) {
                x = (x % width_ + width_) % width_;
                y = (y % height_ + height_) % height_;
            }
            if (x < 0 || x >= width_ || y < 0 || y >= height_) continue;
            if (!taken_.insert(key(x, y)).second) continue;
            site.x = static_cast<std::uint32_t>(x);
            site.y = static_cast<std::uint32_t>(y);
            return;
        }
    }

private:
    static std::uint64_t key(std::int64_t x, std::int64_t y) {
        return static_cast<std::uint64_t>(x) << 32 | static_cast<std::uint64_t>(y);
    }

    std::int64_t width_;
    std::int64_t height_;
    bool wraps_;
    std::set<std::uint64_t> taken_;
    std::map<std::uint64_t, std::uint64_t> tried_;  // offsets around each crowded spot
};

}  // namespace

void take_apart(std::vector<Site>& sites, const portable::RelaxLattice& numbers) {
    std::vector<std::uint32_t> order(sites.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto place = [&](std::uint32_t i) { return std::tie(sites[i].x, sites[i].y); };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return place(a) != place(b) ? place(a) < place(b) : a < b;
    });
    std::vector<std::uint32_t> again;
    for (std::size_t i = 1; i < order.size(); ++i)
        if (place(order[i]) == place(order[i - 1])) again.push_back(order[i]);
    if (again.empty()) return;
    std::sort(again.begin(), again.end());
    Spots spots(numbers, sites);
    for (const std::uint32_t i : again) spots.move_away(sites[i]);
}

}  // namespace lacuna::relaxing
