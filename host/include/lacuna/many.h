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
#include <span>

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

}  // namespace lacuna
