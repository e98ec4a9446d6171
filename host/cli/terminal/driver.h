// What becomes of the program when a backend's driver ends it.
#pragma once

#include <lacuna/lacuna.h>
#include <signal.h>

#include <array>
#include <string>
#include <vector>

namespace lacuna::cli {

// Drivers call exit(1), which would mean a failed check, or abort(), when they find no room, no
// thread or no memory, and some crash. While one of these lives, that is told in one line on
// standard error, and the exit code is that of a device that failed. Not to be nested.
//
// It is to watch the run: drivers that compile with LLVM bring LLVM's handlers of the same signals,
// which come back from an abort() that is then deadly, and swallow a SIGQUIT. So those here, and
// those of Interruption, are set anew at each verb; only an abort() while devices are first looked
// for ends with 134.
class DriverAtWork : public Observer {
public:
    // As a request names it. cpu and reference have no driver: a crash of theirs is Lacuna's own.
    explicit DriverAtWork(const std::string& backend);
    ~DriverAtWork() override;
    DriverAtWork(const DriverAtWork&) = delete;
    DriverAtWork& operator=(const DriverAtWork&) = delete;

    void begin(Verb verb) override;

private:
    void set_handlers() const;

    static constexpr std::array kSignals{SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV};
    bool has_driver_;
    std::array<struct sigaction, kSignals.size()> before_{};
    static constexpr std::array kInterruptions{SIGINT, SIGTERM, SIGHUP, SIGQUIT};
    std::array<struct sigaction, kInterruptions.size()> interruptions_{};
};

// lacuna::devices(), with its drivers watched.
std::vector<Device> listed_devices();

}  // namespace lacuna::cli
