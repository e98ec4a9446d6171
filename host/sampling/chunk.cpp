// lacuna::chunk: what a chunk of the plane keeps, so that the order of chunks does not matter.
//
// By the parity of I and J chunks have four colours, and no two that touch have the same. A chunk
// keeps the points of those that touch it and have a lower colour, which are made before it in the
// same way. Two points of chunks that do not touch are farther apart than any distance that they
// keep, and of two chunks that touch one keeps the points of the other.
#include <lacuna/many.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "base/number_text.h"
#include "checks/classes.h"
#include "rounds/random.h"

namespace lacuna {
namespace {

constexpr std::uint32_t kStreamOfChunks = 0xc4a7;
constexpr std::int64_t kMostChunk = 1 << 20;  // as doubles resolve a grid no farther from 0
constexpr double kRoundingOfChunk = 0x1p-20;  // of the size: more than a distance is rounded up

void refuse_beside_chunk(const Request& request) {
    const auto refuse = [](const std::string& with, const char* why) {
        throw BadRequest("chunk", with, why);
    };
    const Places& places = request.places;
    const auto lacks_extent = [](const Mask* mask) {
        return mask != nullptr && (!mask->extent || mask->drawn != nullptr);
    };
    if (request.domain.wraps()) refuse("on a torus", "which has no chunks beside it");
    if (request.mode != Mode::exact)
        refuse("with mode " + std::string(name_of(request.mode)), "is for mode exact");
    if (request.field != nullptr) refuse("with --field", "is for radii that are alike everywhere");
    if (request.count) refuse("with --count", "each set would have a radius of its own");
    if (request.limit) refuse("with a limit", "sets that have gaps leave them between chunks, too");
    if (request.progressive) refuse("with a progressive order", "points outside are kept");
    if (!request.keep.empty()) refuse("with kept points", "those of chunks beside it are kept");
    if (places.border != 0 || !places.borders.empty() || places.border_by_radius)
        refuse("with a border", "it would leave gaps where chunks meet: give --avoid FILE:D");
    if (lacks_extent(places.mask) ||
        std::any_of(places.masks.begin(), places.masks.end(), lacks_extent))
        refuse("with a mask", "needs the place of its picture, as in FILE@X0,Y0+WxH");
}

void check_chunk_size(const Request& request, double size) {
    const double greatest =
        greatest_share(request.classes) *
        request.radius.value_or(request.classes.names.empty() ? 0
                                                              : least_distance_of(request.classes));
    if (!std::isfinite(size) || !(size > greatest * (1 + kRoundingOfChunk)))
        throw BadRequest("chunk-size", shortest(size),
                         "must be a finite number over " + rounded(greatest, 10) +
                             ", the greatest distance of two points");
}

int colour_of(std::int64_t i, std::int64_t j) {
    return static_cast<int>((i & 1) + 2 * (j & 1));
}

class Plane {
public:
    Plane(const Request& request, double size, MadeChunks& made, Observer& observer)
        : request_(request), size_(size), made_(made), observer_(observer) {
        request_.domain = {};
        for (Outline& outline : request_.places.outlines) outline.polygons.page.reset();
    }

    Chunk chunk(std::int64_t i, std::int64_t j) {
        const auto ring = std::make_shared<TileRing>();
        for (const std::int64_t down : {-1, 0, 1})
            for (const std::int64_t along : {-1, 0, 1})
                if (colour_of(i + along, j + down) < colour_of(i, j))
                    add(points_of(i + along, j + down), *ring);
        Chunk chunk{request_, ring};
        Domain& domain = chunk.request.domain;
        domain.x0 = edge(i);
        domain.y0 = edge(j);
        domain.width = edge(i + 1) - domain.x0;  // exact, so that the next one begins where it ends
        domain.height = edge(j + 1) - domain.y0;
        const std::uint64_t column =
            random_bits(request_.seed, static_cast<std::uint64_t>(i), kStreamOfChunks).first;
        chunk.request.seed =
            random_bits(column, static_cast<std::uint64_t>(j), kStreamOfChunks).first;
        chunk.request.keep = ring->points;
        chunk.request.keep_classes = ring->classes;
        return chunk;
    }

private:
    double edge(std::int64_t number) const { return static_cast<double>(number) * size_; }

    const TileRing& points_of(std::int64_t i, std::int64_t j) {
        if (const auto found = made_.find({i, j}); found != made_.end()) return found->second;
        const Chunk one = chunk(i, j);
        Result set = sample(one.request, observer_);
        return made_[{i, j}] = {std::move(set.points), std::move(set.classes)};
    }

    static void add(const TileRing& more, TileRing& ring) {
        ring.points.insert(ring.points.end(), more.points.begin(), more.points.end());
        ring.classes.insert(ring.classes.end(), more.classes.begin(), more.classes.end());
    }

    Request request_;
    double size_;
    MadeChunks& made_;
    Observer& observer_;
};

}  // namespace

Chunk chunk(const Request& request, std::int64_t i, std::int64_t j, double size) {
    MadeChunks made;
    Observer nobody;
    return chunk(request, i, j, size, made, nobody);
}

Chunk chunk(const Request& request, std::int64_t i, std::int64_t j, double size, MadeChunks& made,
            Observer& observer) {
    refuse_beside_chunk(request);
    for (const std::int64_t number : {i, j})
        if (number < -kMostChunk || number > kMostChunk)
            throw BadRequest("chunk", std::to_string(i) + "," + std::to_string(j),
                             "must be two whole numbers of at most " + std::to_string(kMostChunk));
    check_chunk_size(request, size);
    return Plane(request, size, made, observer).chunk(i, j);
}

}  // namespace lacuna
