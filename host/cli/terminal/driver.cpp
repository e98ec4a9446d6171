// Handlers of signals and of exit(), for drivers that end the program.
#include "cli/terminal/driver.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <string_view>

#include "backends/backends.h"
#include "cli/terminal/run_program.h"

namespace lacuna::cli {
namespace {

std::atomic<bool> driver_at_work = false;
static_assert(std::atomic<bool>::is_always_lock_free);  // handlers may use no other atomics

// The beginning of the message, as plain bytes: a signal handler may not allocate memory.
std::array<char, 80> line_begin{};

void tell(std::string_view text) {
    // If this fails, nothing can be done about it.
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

[[noreturn]] void tell_of_driver_and_exit(std::string_view how) {
    driver_at_work = false;  // so that the message is not printed twice
    tell(line_begin.data());
    tell(": its driver ended the program by ");
    tell(how);
    tell("\n");
    _exit(kExitDevice);
}

void on_driver_exit() {
    if (driver_at_work) tell_of_driver_and_exit("exit()");
}

std::string_view name_of_signal(int signal) {
    switch (signal) {
        case SIGABRT:
            return "abort()";
        case SIGBUS:
            return "SIGBUS";
        case SIGFPE:
            return "SIGFPE";
        case SIGILL:
            return "SIGILL";
        default:
            return "SIGSEGV";
    }
}

void on_driver_signal(int signal) {
    tell_of_driver_and_exit(name_of_signal(signal));
}

// For an exception that leaves a driver's thread. The default handler would add lines of its own.
[[noreturn]] void on_driver_terminate() {
    tell_of_driver_and_exit("an exception");
}

bool has_driver(const std::string& backend) {
    const std::string name = wanted_backend(backend);
    return name != "auto" && name != "cpu" && name != "reference";
}

}  // namespace

DriverAtWork::DriverAtWork(const std::string& backend) : has_driver_(has_driver(backend)) {
    if (!has_driver_) return;
    static const bool is_registered = std::atexit(on_driver_exit) == 0;
    static_cast<void>(is_registered);
    const std::string text = "lacuna: backend " + wanted_backend(backend);
    line_begin = {};
    std::copy_n(text.begin(), std::min(text.size(), line_begin.size() - 1), line_begin.begin());
    driver_at_work = true;
    terminate_before_ = std::set_terminate(on_driver_terminate);

    // Handlers have a stack of their own: the normal one may have overflowed.
    static std::array<char, std::size_t{1} << 16U> other_stack;
    stack_t stack{};
    stack.ss_sp = other_stack.data();
    stack.ss_size = other_stack.size();
    sigaltstack(&stack, nullptr);
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], nullptr, &before_[i]);
    for (std::size_t i = 0; i < kInterruptions.size(); ++i)
        sigaction(kInterruptions[i], nullptr, &interruptions_[i]);
    set_handlers();
}

void DriverAtWork::begin(Verb) {
    if (has_driver_) set_handlers();
}

void DriverAtWork::set_handlers() const {
    struct sigaction action {};
    action.sa_handler = on_driver_signal;
    action.sa_flags = SA_ONSTACK;
    sigfillset(&action.sa_mask);
    // Handlers that were set before are kept: sanitizers have their own.
    for (std::size_t i = 0; i < kSignals.size(); ++i)
        if (before_[i].sa_handler == SIG_DFL) sigaction(kSignals[i], &action, nullptr);
    for (std::size_t i = 0; i < kInterruptions.size(); ++i)
        sigaction(kInterruptions[i], &interruptions_[i], nullptr);
}

DriverAtWork::~DriverAtWork() {
    if (!has_driver_) return;
    set_handlers();
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
    std::set_terminate(terminate_before_);
    driver_at_work = false;
}

std::vector<Device> listed_devices() {
    const DriverAtWork driver("opencl or vulkan");
    return devices();
}

}  // namespace lacuna::cli
