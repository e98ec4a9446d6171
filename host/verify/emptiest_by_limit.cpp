// Branch and bound over rectangles: each is cut in two, at pixels' borders while its places differ,
// until one sample is seen to cover all of it with the least radius under it, until no sample may
// lie in it, or until no spot of it can be barer than the barest found.
#include "verify/emptiest_by_limit.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "verify/bounds.h"
#include "verify/emptiest.h"
#include "verify/limit_search.h"

namespace lacuna::verify {
namespace {

constexpr int kTilesAlongBounds = 4;
// Every so many-th tile is searched first: what it finds spares the others most of their work.
constexpr std::size_t kScoutStepOfTiles = 4;
// A cell with fewer disks near it is searched by one thread, and so is one after so many cuts.
constexpr std::size_t kFewForThreads = 4096;
constexpr int kCutsForThreads = 12;

std::vector<Cell> tiles_within(const Cell& bounds) {
    if (bounds.right < bounds.left || bounds.top < bounds.bottom) return {};
    const double width = bounds.right - bounds.left;
    const double height = bounds.top - bounds.bottom;
    if (width == 0 && height == 0) return {bounds};
    const auto tiles_along = [&](double side) {
        return std::max(
            1, static_cast<int>(std::ceil(kTilesAlongBounds * (side / std::max(width, height)))));
    };
    const auto columns = tiles_along(width);
    const auto rows = tiles_along(height);
    const auto cut = [](double low, double high, int i, int count) {
        return i == count ? high : low + (high - low) * i / count;
    };
    std::vector<Cell> tiles;
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j)
            tiles.push_back({cut(bounds.left, bounds.right, i, columns),
                             cut(bounds.left, bounds.right, i + 1, columns),
                             cut(bounds.bottom, bounds.top, j, rows),
                             cut(bounds.bottom, bounds.top, j + 1, rows)});
    return tiles;
}

// The images of a sample, beyond a torus' edges, that can be nearest to some place of an interval.
struct Images {
    double first;
    double second;  // the same when there is but one

    Images(bool torus, double at, double middle, double half, double side)
        : first(torus ? at - side * std::round((at - middle) / side) : at), second(first) {
        const double offset = first - middle;
        if (torus && std::abs(offset) > side / 2 - half)
            second = offset > 0 ? first - side : first + side;
    }
};

// The disks, with a torus' images, that matter to a tile.
std::vector<Disk> disks_near(const Limits& limits, const Cell& tile, const Under& under,
                             std::span<const Disk> disks) {
    const Domain& domain = limits.ground.domain();
    const Frame frame(tile);
    const auto images_of = [&](const Disk& disk) {
        return std::pair{
            Images(domain.torus, disk.at.x, frame.centre.x, frame.half_width, domain.width),
            Images(domain.torus, disk.at.y, frame.centre.y, frame.half_height, domain.height)};
    };
    const Bounds bounds(frame, under);
    double most_over = std::numeric_limits<double>::infinity();
    for (const Disk& disk : disks) {
        const auto [x, y] = images_of(disk);
        most_over = std::min(most_over, bounds.most_over({{x.first, y.first}, disk.radius}));
    }
    std::vector<Disk> near;
    const auto append = [&](double x, double y, double radius) {
        const Disk disk{{x, y}, radius};
        if (bounds.may_matter(disk, most_over + limits.rounding)) near.push_back(disk);
    };
    for (const Disk& disk : disks) {
        const auto [x, y] = images_of(disk);
        append(x.first, y.first, disk.radius);
        if (x.second != x.first) append(x.second, y.first, disk.radius);
        if (y.second != y.first) append(x.first, y.second, disk.radius);
        if (x.second != x.first && y.second != y.first) append(x.second, y.second, disk.radius);
    }
    thin_out(tile, bounds, disks.size(), near, 0);
    return near;
}

const BareSpot& barer(const BareSpot& a, const BareSpot& b) {
    return b.over > a.over ? b : a;
}

// No part sees what another finds, or the spot would depend on which thread comes first.
BareSpot search_with_threads(const Limits& limits, const BareSpot& start, const Cell& cell,
                             const Under& under, std::vector<Disk> disks, int cuts) {
    limits.patience.look();
    if (cuts == kCutsForThreads || disks.size() < kFewForThreads || under.is_closed())
        return LimitSearch(limits, start).run(cell, under, std::move(disks));
    const Cut cut = limits.ground.cut(cell, under);
    const auto search = [&](const Cell& half) {
        const Under below = limits.ground.under(half, under);
        const Bounds bounds(Frame(half), below);
        double most_over = std::numeric_limits<double>::infinity();
        for (const Disk& disk : disks) most_over = std::min(most_over, bounds.most_over(disk));
        std::vector<Disk> near;
        for (const Disk& disk : disks)
            if (bounds.may_matter(disk, most_over + limits.rounding)) near.push_back(disk);
        thin_out(half, bounds, disks.size(), near, 0);
        return search_with_threads(limits, start, half, below, std::move(near), cuts + 1);
    };
    BareSpot low, high;
    oneapi::tbb::parallel_invoke([&] { low = search(cut.low(cell)); },
                                 [&] { high = search(cut.high(cell)); });
    return barer(low, high);
}

BareSpot search_tiles(const Limits& limits, const BareSpot& start, std::span<const Cell> tiles,
                      std::span<const Disk> disks) {
    std::vector<BareSpot> found(tiles.size());
    oneapi::tbb::parallel_for(std::size_t{0}, tiles.size(), [&](std::size_t i) {
        limits.patience.look();
        const Under under = limits.ground.under(tiles[i], {});
        if (under.is_closed()) return;
        found[i] = search_with_threads(limits, start, tiles[i], under,
                                       disks_near(limits, tiles[i], under, disks), 0);
    });
    BareSpot barest = start;
    for (const BareSpot& spot : found) barest = barer(barest, spot);
    return barest;
}

// As a user would compute it, without the roundings of images.
void measure(const Domain& domain, std::span<const Disk> disks, BareSpot& spot) {
    spot.over = std::numeric_limits<double>::infinity();
    for (const Disk& disk : disks) {
        const double distance = domain.distance(spot.at, disk.at);
        const double limit = std::min(spot.radius, disk.radius);
        if (distance - limit >= spot.over) continue;
        spot.over = distance - limit;
        spot.distance = distance;
        spot.limit = limit;
    }
}

}  // namespace

BareSpot emptiest_by_limit(const Ground& ground, std::span<const Disk> disks, double tolerance,
                           const Patience& patience) {
    const Domain& domain = ground.domain();
    const Limits limits{ground, tolerance, kFinest * domain.longer_side(), domain.rounding(),
                        patience};
    std::vector<Cell> scouts;
    std::vector<Cell> others;
    for (const Cell& tile : tiles_within(ground.bounds()))
        ((scouts.size() + others.size()) % kScoutStepOfTiles == 0 ? scouts : others)
            .push_back(tile);
    BareSpot barest = search_tiles(limits, {}, scouts, disks);
    barest = search_tiles(limits, barest, others, disks);
    if (barest.over > -std::numeric_limits<double>::infinity()) measure(domain, disks, barest);
    return barest;
}

}  // namespace lacuna::verify
