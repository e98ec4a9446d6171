// Ctrl-C, SIGTERM, SIGHUP and SIGQUIT end the program at once, except that files that are being
// written are finished first.
#pragma once

#include <signal.h>

#include <array>
#include <cstddef>

namespace lacuna::cli {

// While an object of this class exists, a signal ends the program with exit code 128 + its number,
// as in shells: 130 after Ctrl-C, 143 after SIGTERM. It does not wait for a round, a driver's
// compiler or a pipe, because there are no unfinished files to remove. Only one object may exist at
// a time.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    // From now on a signal no longer says that nothing was written: files of earlier sets are
    // there.
    static void note_files();
    // From now on signals wait.
    static void finish_files_first();
    // From now on signals no longer wait: writing to streams may block for ever. Ends the program
    // if a signal has been waiting.
    static void exit_at_once();

    // Whether a signal is to clear the progress bar's line on standard error.
    static void clears_line(bool clears);

private:
    static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP, SIGQUIT};
    std::array<struct sigaction, kSignals.size()> before_{};
};

}  // namespace lacuna::cli
