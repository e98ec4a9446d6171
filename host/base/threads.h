// Whether the system makes the threads that work is to be shared out among.
#pragma once

#include <cstdint>

namespace lacuna {

// Of one run: far more take more memory than they save time.
inline constexpr std::uint32_t kMostThreads = 1024;

// oneTBB makes its threads when there is first work for them, and where the system refuses one the
// whole program dies. To be called right before: makes so many less one, the caller's, and lets
// them go again, once a process for each greater number. Throws Unavailable where one is refused.
void make_sure_of_threads(int threads);

// As many as oneTBB uses where nothing else is said.
void make_sure_of_threads();

// Up to kMostThreads: oneTBB uses no more than one a core, and prints a warning when asked to,
// unless this was called.
void allow_more_threads_than_cores();

}  // namespace lacuna
