// The signal handler, and the variables through which the run tells it what to do.
#include "cli/terminal/interruption.h"

#include <unistd.h>

#include <atomic>
#include <string_view>

namespace lacuna::cli {
namespace {

enum class OnSignal { tell_and_exit, finish_files, exit };

std::atomic<OnSignal> on_signal = OnSignal::tell_and_exit;
std::atomic<bool> line_to_clear = false;
std::atomic<bool> has_files = false;
std::atomic<int> waiting = 0;  // the signal that came while files were written, or 0
static_assert(std::atomic<OnSignal>::is_always_lock_free);  // handlers may use no other atomics
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

void say(std::string_view text) {
    // If this fails, nothing can be done about it.
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

void handle(int signal) {
    const OnSignal what = on_signal;
    if (what == OnSignal::finish_files) {
        waiting = signal;
        return;
    }
    if (line_to_clear) say("\r\x1b[K");
    if (what == OnSignal::tell_and_exit)
        say(has_files ? "lacuna: interrupted, only files of earlier pictures were written\n"
                      : "lacuna: interrupted, nothing was written\n");
    _exit(128 + signal);
}

}  // namespace

Interruption::Interruption() {
    on_signal = OnSignal::tell_and_exit;
    struct sigaction action {};
    action.sa_handler = handle;
    action.sa_flags = SA_RESTART;
    sigfillset(&action.sa_mask);  // no second signal interrupts the handler
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        sigaction(kSignals[i], nullptr, &before_[i]);
        // Signals that are ignored stay ignored, as `nohup` and `&` in scripts want it.
        if (before_[i].sa_handler != SIG_IGN) sigaction(kSignals[i], &action, nullptr);
    }
}

Interruption::~Interruption() {
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
}

void Interruption::finish_files_first() {
    on_signal = OnSignal::finish_files;
}

void Interruption::note_files() {
    has_files = true;
}

void Interruption::exit_at_once() {
    on_signal = OnSignal::exit;
    if (const int signal = waiting; signal != 0) _exit(128 + signal);
}

void Interruption::clears_line(bool clears) {
    line_to_clear = clears;
}

}  // namespace lacuna::cli
