// Signal handlers that remove a file.
#include "mpi/unfinished_file.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <climits>
#include <string_view>

namespace lacuna::mpi {
namespace {

// Plain bytes: a handler may not take memory.
std::array<char, PATH_MAX> unfinished{};
std::atomic<bool> is_there = false;
std::atomic<bool> is_speaker = false;
static_assert(std::atomic<bool>::is_always_lock_free);  // else not for signal handlers

void remove_and_exit(int signal) {
    if (is_there) ::unlink(unfinished.data());
    constexpr std::string_view kMessage = "lacuna-mpi: interrupted, nothing was written\n";
    if (is_speaker) {
        // There is nothing left to do about a failure.
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
    struct sigaction action {};
    action.sa_handler = remove_and_exit;
    sigfillset(&action.sa_mask);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
        struct sigaction before {};
        sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
    }
}

}  // namespace lacuna::mpi
