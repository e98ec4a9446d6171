// Many sets of one request, a seed each: small sets are shared out among the threads, a set a task.
// Link lacuna.
//
// What is promised
//   - Each set is what sample() makes of the request with that seed, byte for byte.
//   - The sets come in the order of the seeds, on the calling thread, whatever the threads do.
//   - Few are in memory at once: of small sets some 64 a thread, of larger ones one.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <functional>
#include <span>

namespace lacuna {

// Is given each set as its turn comes. May throw: that ends sample_many(), which passes it on.
using TakeSet = std::function<void(std::uint64_t seed, Result set)>;

// Makes a set of `request` for each of `seeds`, whatever its own seed says. Sets of at most some
// 20,000 points in rounds of automatic size on the cpu are made several at once, each on one
// thread; all others one after the other, each on all threads or on the device. `observer` is asked
// on the calling thread whether to go on; its Progress counts sets: those that are done, all of
// them, and no rounds. It is told of no verbs, for they run at the same time. Throws what sample()
// throws.
void sample_many(const Request& request, std::span<const std::uint64_t> seeds, const TakeSet& take);
void sample_many(const Request& request, std::span<const std::uint64_t> seeds, const TakeSet& take,
                 Observer& observer);

}  // namespace lacuna
