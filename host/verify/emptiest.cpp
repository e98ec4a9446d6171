// Branch and bound over rectangles: each is halved until one disk is seen to cover all of it, or
// until it cannot hold an emptier spot than the emptiest found.
#include "verify/emptiest.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "verify/search.h"

namespace lacuna::verify {
namespace {

// Tiles are few, so that a crowd near one of them is not looked through too often.
constexpr int kTilesAlongLongerSide = 16;
// Every so many-th tile is searched first: what it finds spares the others most of their work.
constexpr std::size_t kScoutStep = 16;

std::vector<double> cuts_of(double side, double longer) {
    const int count =
        std::max(1, static_cast<int>(std::ceil(kTilesAlongLongerSide * (side / longer))));
    std::vector<double> cuts(static_cast<std::size_t>(count) + 1);
    for (int i = 0; i <= count; ++i) cuts[static_cast<std::size_t>(i)] = side * i / count;
    return cuts;
}

std::vector<Cell> tiles_of(const Domain& domain) {
    const std::vector<double> xs = cuts_of(domain.width, domain.longer_side());
    const std::vector<double> ys = cuts_of(domain.height, domain.longer_side());
    std::vector<Cell> tiles;
    for (std::size_t i = 0; i + 1 < xs.size(); ++i)
        for (std::size_t j = 0; j + 1 < ys.size(); ++j)
            tiles.push_back({xs[i], xs[i + 1], ys[j], ys[j + 1]});
    return tiles;
}

const Spot& emptier(const Spot& a, const Spot& b) {
    return b.distance > a.distance ? b : a;
}

// Searches every `step`-th tile. No tile sees what another finds, or the spot would depend on which
// thread comes first.
Spot search_tiles(const Neighbours& neighbours, const std::vector<Cell>& tiles, std::size_t step,
                  const Goal& goal, const Spot& start, const Patience& patience) {
    std::vector<Spot> found((tiles.size() + step - 1) / step);
    oneapi::tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
        const Cell& tile = tiles[i * step];
        found[i] = Search(goal, start, neighbours.domain().rounding(), patience)
                       .run(tile, neighbours.of(tile));
    });
    Spot emptiest = start;
    for (const Spot& spot : found) emptiest = emptier(emptiest, spot);
    return emptiest;
}

// The emptiest spot is found to kSpotPrecision; its surroundings show the place to the last digits.
Spot sharpen(const Neighbours& neighbours, const Spot& spot, double finest,
             const Patience& patience) {
    const Domain& domain = neighbours.domain();
    const double reach = 4 * kSpotPrecision * spot.distance;
    const Cell around{std::max(0.0, spot.at.x - reach), std::min(domain.width, spot.at.x + reach),
                      std::max(0.0, spot.at.y - reach), std::min(domain.height, spot.at.y + reach)};
    const Goal goal{.relative = 0, .finest = finest, .limit = spot.distance + 2 * reach};
    return Search(goal, spot, domain.rounding(), patience).run(around, neighbours.of(around));
}

}  // namespace

Spot emptiest_spot(const Domain& domain, std::span<const Point> points, double limit,
                   const Patience& patience) {
    if (points.empty()) return {{domain.width / 2, domain.height / 2}};
    const Neighbours neighbours(domain, points, patience);
    const std::vector<Cell> tiles = tiles_of(domain);
    const double finest = kFinest * domain.longer_side();
    const Goal goal{.relative = kSpotPrecision, .finest = finest, .limit = limit};
    Spot spot = search_tiles(neighbours, tiles, kScoutStep, goal, {{0, 0}, 0}, patience);
    spot = search_tiles(neighbours, tiles, 1, goal, spot, patience);
    spot = sharpen(neighbours, spot, finest, patience);

    // As a user would compute it, without the roundings of images.
    spot.distance = domain.distance(spot.at, points[0]);
    for (const Point& point : points)
        spot.distance = std::min(spot.distance, domain.distance(spot.at, point));
    return spot;
}

}  // namespace lacuna::verify
