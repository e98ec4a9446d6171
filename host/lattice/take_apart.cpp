// Moves sites that have the same position to free positions nearby.
#include "lattice/take_apart.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "lattice/ranked.h"

namespace lacuna::relaxing {
namespace {

// Offset i of a spiral around (0, 0), ring after ring.
struct Offset {
    std::int64_t x;
    std::int64_t y;
};
Offset spiral(std::uint64_t i) {
    if (i == 0) return {0, 0};
    std::int64_t ring = 1;
    std::int64_t before = 1;  // number of offsets in smaller rings
    while (before + 8 * ring <= static_cast<std::int64_t>(i)) before += 8 * ring++;
    const std::int64_t along = static_cast<std::int64_t>(i) - before;
    const std::int64_t side = along / (2 * ring);
    const std::int64_t way = along % (2 * ring) - ring;
    if (side == 0) return {way, -ring};
    if (side == 1) return {ring, way};
    if (side == 2) return {-way, ring};
    return {-ring, -way};
}

std::uint64_t key(std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) << 32 | static_cast<std::uint64_t>(y);
}

class Spots {
public:
    // `places` are the keys of all sites' positions, sorted.
    Spots(const portable::RelaxLattice& numbers, const std::vector<Ranked>& places)
        : places_(places),
          width_(std::int64_t{numbers.columns} * numbers.step_x),
          height_(std::int64_t{numbers.rows} * numbers.step_y),
          wraps_(numbers.period_x != 0) {}

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
            if (!take(key(x, y))) continue;
            site.x = static_cast<std::uint32_t>(x);
            site.y = static_cast<std::uint32_t>(y);
            return;
        }
    }

private:
    // Returns false if a site is already there.
    bool take(std::uint64_t spot) {
        const auto place = std::lower_bound(
            places_.begin(), places_.end(), spot,
            [](const Ranked& site, std::uint64_t wanted) { return site.rank < wanted; });
        return (place == places_.end() || place->rank != spot) && taken_.insert(spot).second;
    }

    const std::vector<Ranked>& places_;
    std::int64_t width_;
    std::int64_t height_;
    bool wraps_;
    std::set<std::uint64_t> taken_;                 // by sites that were moved
    std::map<std::uint64_t, std::uint64_t> tried_;  // offsets tried, by crowded position
};

}  // namespace

void take_apart(std::vector<Site>& sites, const portable::RelaxLattice& numbers, const Poll& poll) {
    std::vector<Ranked> places(sites.size());
    for_each_polled(sites.size(), poll, [&](std::size_t i) {
        places[i] = {key(sites[i].x, sites[i].y), static_cast<std::uint32_t>(i)};
    });
    sort_by_rank(places, poll);
    std::vector<Ranked> again;
    for (std::size_t i = 1; i < places.size(); ++i)
        if (places[i].rank == places[i - 1].rank) again.push_back({places[i].index, 0});
    sort_by_rank(again, poll);
    Spots spots(numbers, places);
    constexpr std::size_t kBetweenPolls = 256;  // a site's search grows with the crowd
    for (std::size_t i = 0; i < again.size(); ++i) {
        if (i % kBetweenPolls == 0) poll();
        spots.move_away(sites[again[i].rank]);
    }
}

}  // namespace lacuna::relaxing
