// Signal handlers that remove the unfinished file.
#include "mpi/unfinished_file.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <climits>
#include <cstdlib>
#include <string_view>

namespace lacuna::mpi {
namespace {

// The file's name as plain bytes: a signal handler may not allocate memory.
std::array<char, PATH_MAX> unfinished{};
std::atomic<bool> is_there = false;
std::atomic<bool> is_speaker = false;
std::atomic<bool> do_wait = false;
std::atomic<int> waiting = 0;  // the signal that came while do_wait was true, or 0
static_assert(std::atomic<bool>::is_always_lock_free);  // handlers may use no other atomics
static_assert(std::atomic<int>::is_always_lock_free);

constexpr std::array kEndingSignals{SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGABRT};

void remove_unfinished() {
    if (is_there) ::unlink(unfinished.data());
}

void remove_and_exit(int signal) {
    if (do_wait) {
        waiting = signal;
        return;
    }
    remove_unfinished();
    constexpr std::string_view kMessage = "lacuna-mpi: interrupted, nothing was written\n";
    if (is_speaker) {
        // If this fails, nothing can be done about it.
        [[maybe_unused]] const ssize_t told =
            ::write(STDERR_FILENO, kMessage.data(), kMessage.size());
    }
    ::_exit(128 + signal);
}

}  // namespace

void remove_on_signal(const std::string& name, bool speaks) {
    is_there = false;
    unfinished.fill('\0');
    std::copy_n(name.begin(), std::min(name.size(), unfinished.size() - 1), unfinished.begin());
    is_there = !name.empty() && name.size() < unfinished.size();
    is_speaker = speaks;
    // MPI may notice the end of another rank before the signal comes, and calls exit() or abort().
    static const bool is_registered = std::atexit(remove_unfinished) == 0;
    static_cast<void>(is_registered);
    struct sigaction action {};
    action.sa_handler = remove_and_exit;
    sigfillset(&action.sa_mask);
    for (const int signal : kEndingSignals) {
        struct sigaction before {};
        sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
    }
}

// Uses a flag. If this thread blocked signals, other threads, of MPI or oneTBB, would receive them.
SignalsWait::SignalsWait() {
    do_wait = true;
}

SignalsWait::~SignalsWait() {
    do_wait = false;
    if (const int signal = waiting; signal != 0) remove_and_exit(signal);
}

}  // namespace lacuna::mpi
