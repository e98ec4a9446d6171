// Ctrl-C and SIGTERM: a run ends at its next round, a file being written is finished first.
#pragma once

#include <lacuna/lacuna.h>
#include <signal.h>

#include <array>
#include <cstddef>

namespace lacuna::cli {

// 128 and the signal's number, as shells have it: 130 after Ctrl-C, 143 after SIGTERM.
int exit_code_of_interruption();

// One at a time: signals belong to the process. While it lives, the first signal makes keep_going
// say no, and a second one, for those who do not want to wait for the round, exits at once.
class Interruption : public Observer {
public:
    Interruption();
    ~Interruption() override;
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    bool keep_going(const Progress& progress) override;

    // The work is done and will be written, to files or to standard output. Files are finished
    // whatever comes; standard output may block for ever, so that there a signal exits at once.
    // Throws Cancelled if a signal came before.
    void start_writing(bool to_file);

private:
    static constexpr std::array kSignals{SIGINT, SIGTERM};
    std::array<struct sigaction, kSignals.size()> before_{};
};

}  // namespace lacuna::cli
