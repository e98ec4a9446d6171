// Many sets of one request, one for each seed. Small sets are made in parallel, one on each thread.
// Link lacuna.
//
// What is promised
//   - Each set is what sample() makes of the request with that seed, byte for byte.
//   - The sets come in the order of the seeds, on the calling thread.
//   - Few sets are in memory at once: about 64 small sets per thread, or one large set.
#pragma once

#include <lacuna/export.h>
#include <lacuna/sample.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace LACUNA_API lacuna {

// Is called with each set in turn. If it throws, sample_many() ends with that exception.
using TakeSet = std::function<void(std::uint64_t seed, Result set)>;

// Makes a set of `request` for each of `seeds`; Request::seed is ignored. Uniform sets of up to
// about 20,000 points are made in parallel, each on one thread, if they run on the cpu in rounds
// of automatic size. All other sets are made one after another, each on all threads or on the
// device. `observer` is called on the calling thread. Its Progress counts sets instead of points,
// and its rounds are 0. begin() and end() are not called, because sets are made at the same time.
// Throws what sample() throws; a request that makes no sense is refused without seeds, too.
void sample_many(const Request& request, std::span<const std::uint64_t> seeds, const TakeSet& take);
void sample_many(const Request& request, std::span<const std::uint64_t> seeds, const TakeSet& take,
                 Observer& observer);

// What all tiles of one request have in common.
struct TileRing {
    std::vector<Point> points{};
    std::vector<std::uint8_t> classes{};  // with classes, of each point
};

// The points of sample(request) that lie within `width` of the edges of the domain, a torus. Where
// Request::keep and keep_classes have them, the sets of any seeds are tiles: in whatever order they
// lie side by side, without gaps and unturned, all of them together are one maximal set. The field,
// mask and radius must be the same for all.
// The width is at least 1.5 times the greatest radius, or greatest distance of two classes: then
// what differs from tile to tile is too far from the edges to matter beyond them. It is under half
// of the shorter side. Throws what sample() throws; BadRequest, too, for a width out of this range,
// and for a box, kept points, a count, a limit, a progressive order and other modes than exact.
TileRing tile_ring(const Request& request, double width);
TileRing tile_ring(const Request& request, double width, Observer& observer);

// A request of sample() for a chunk of the plane, and what its Request::keep has: points of the
// chunks beside it.
struct Chunk {
    Request request = Request();
    std::shared_ptr<const TileRing> beside{};
};

// Points of chunks, by their I and J.
using MadeChunks = std::map<std::pair<std::int64_t, std::int64_t>, TileRing>;

// The chunk [I size, (I + 1) size) x [J size, (J + 1) size) of a plane that is cut into squares.
// The set of each is the same in whatever order chunks are made, and all of them together are one
// maximal set, without gaps and conflicts where they meet. For that a chunk keeps points of some of
// the eight chunks beside it, which are made on the way: up to 16 others, 7 on average. Each has a
// seed of its own, from Request::seed, I and J. What two chunks need, `made` need not be given
// twice: it has the points of chunks of the same request and size, and is given those of the chunks
// that were made.
// Polygons lie in the plane, whatever their page. Masks must have an extent. Throws what sample()
// throws; BadRequest, too, for I and J over 2^20, for a size that is not over the greatest distance
// of two points, and for a torus, kept points, a border, a field, a count, a limit, a progressive
// order and other modes than exact.
Chunk chunk(const Request& request, std::int64_t i, std::int64_t j, double size);
Chunk chunk(const Request& request, std::int64_t i, std::int64_t j, double size, MadeChunks& made,
            Observer& observer);

}  // namespace lacuna
