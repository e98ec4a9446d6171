// The signal handler and the one word that it shares with the run.
#include "cli/interruption.h"

#include <unistd.h>

#include <atomic>

namespace lacuna::cli {
namespace {

enum class OnSignal { ask_to_stop, exit_at_once, finish_first };

std::atomic<OnSignal> on_signal = OnSignal::ask_to_stop;
static_assert(std::atomic<OnSignal>::is_always_lock_free);  // else not for signal handlers

std::atomic<int> signal_seen = SIGINT;

int exit_code(int signal) {
    return 128 + signal;
}

void handle(int signal) {
    signal_seen = signal;
    OnSignal expected = OnSignal::ask_to_stop;
    if (on_signal.compare_exchange_strong(expected, OnSignal::exit_at_once)) return;
    if (expected == OnSignal::exit_at_once) _exit(exit_code(signal));
}

}  // namespace

int exit_code_of_interruption() {
    return exit_code(signal_seen);
}

Interruption::Interruption() {
    on_signal = OnSignal::ask_to_stop;
    struct sigaction action {};
    action.sa_handler = handle;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        sigaction(kSignals[i], nullptr, &before_[i]);
        // Ignored signals stay so: `nohup` and `&` in scripts ask for that.
        if (before_[i].sa_handler != SIG_IGN) sigaction(kSignals[i], &action, nullptr);
    }
}

Interruption::~Interruption() {
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
}

bool Interruption::keep_going(const Progress&) {
    return on_signal == OnSignal::ask_to_stop;
}

void Interruption::start_writing(bool to_file) {
    const OnSignal next = to_file ? OnSignal::finish_first : OnSignal::exit_at_once;
    if (on_signal.exchange(next) != OnSignal::ask_to_stop) throw Cancelled();
}

}  // namespace lacuna::cli
