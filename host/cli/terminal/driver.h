// A message and an exit code for the case that a backend's driver ends the program.
#pragma once

#include <lacuna/lacuna.h>
#include <signal.h>

#include <array>
#include <exception>
#include <string>
#include <vector>

namespace lacuna::cli {

// When drivers lack disk space, threads or memory, some call exit(1), which would mean a failed
// check, or abort(). Some crash, or let an exception leave one of their threads. While an object of
// this class exists, the program then prints one line on standard error and exits with kExitDevice.
// What the driver itself has printed, such as a failed assertion, stands above that line. Objects
// must not be nested.
//
// The object must observe the run. Drivers that compile with LLVM install LLVM's handlers of these
// signals. After them an abort() kills the program without a message, and a SIGQUIT is swallowed.
// Therefore the handlers of this class and of Interruption are set again at each verb. An abort()
// while devices are listed for the first time still ends the program with exit code 134.
class DriverAtWork : public Observer {
public:
    // `backend` is as in Request. cpu and reference have no driver: their crashes are Lacuna's.
    explicit DriverAtWork(const std::string& backend);
    ~DriverAtWork() override;
    DriverAtWork(const DriverAtWork&) = delete;
    DriverAtWork& operator=(const DriverAtWork&) = delete;

    void begin(Verb verb) override;

private:
    void set_handlers() const;

    static constexpr std::array kSignals{SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV};
    bool has_driver_;
    std::terminate_handler terminate_before_ = nullptr;
    std::array<struct sigaction, kSignals.size()> before_{};
    static constexpr std::array kInterruptions{SIGINT, SIGTERM, SIGHUP, SIGQUIT};
    std::array<struct sigaction, kInterruptions.size()> interruptions_{};
};

// Calls lacuna::devices() while the drivers are watched.
std::vector<Device> listed_devices();

}  // namespace lacuna::cli
