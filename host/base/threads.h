// Makes sure that the system allows the threads of a run.
#pragma once

#include <cstdint>

namespace lacuna {

// Most threads of one run. Each takes memory, and more threads than this save no time.
inline constexpr std::uint32_t kMostThreads = 1024;

// To be called before oneTBB is given work: it starts its threads then, and ends the program if the
// system refuses one. This starts `threads` - 1 threads (the caller is the last) and ends them
// again, unless it did so before for as large a number. Throws Unavailable if one is refused.
// oneTBB may then keep that many threads, and no more: under load it starts further ones up to its
// limit, although some are about to be idle, and never ends any.
void make_sure_of_threads(int threads);

// The same for oneTBB's default number of threads.
void make_sure_of_threads();

}  // namespace lacuna
