// Ctrl-C, SIGTERM, SIGHUP and SIGQUIT: the program ends at once, but files that are being written
// are finished first.
#pragma once

#include <signal.h>

#include <array>
#include <cstddef>

namespace lacuna::cli {

// One at a time: signals belong to the process. While it lives, a signal ends the program with 128
// and its number, as shells have it: 130 after Ctrl-C, 143 after SIGTERM. It does not wait for
// whatever is under way, a round, a compiler of a driver's, a pipe that nobody writes into:
// nothing is on the disk that would have to be taken away.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    // From now on a signal waits.
    static void finish_files_first();
    // No longer: what is written now may block for ever. Ends the program if one has waited.
    static void exit_at_once();

    // Whether a line on standard error, the progress bar's, is to be cleared first.
    static void clears_line(bool clears);

private:
    static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP, SIGQUIT};
    std::array<struct sigaction, kSignals.size()> before_{};
};

}  // namespace lacuna::cli
