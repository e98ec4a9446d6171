// A program with subcommands: its messages, and the exit code of each exception.
#pragma once

#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace lacuna::cli {

// The exit codes of the program, besides 0 and 128 + a signal's number.
inline constexpr int kExitCheckFailed = 1;
inline constexpr int kExitBadUsage = 2;
inline constexpr int kExitFile = 3;
inline constexpr int kExitDevice = 4;
inline constexpr int kExitBug = 70;  // EX_SOFTWARE of sysexits.h

// The exception of a command that has done its work and has found a check failed. The result has
// been printed. The exit code becomes kExitCheckFailed.
class CheckFailed : public std::exception {};

// A mistake in the command line; what() is one line.
class BadUsage : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Text for a terminal, on one line: control characters, invisible characters and bytes that are not
// UTF-8 are escaped.
std::string printable(std::string_view text);

class Program {
public:
    Program(std::string name, std::string description, std::function<void(CLI::App&)> add_commands)
        : name_(std::move(name)),
          description_(std::move(description)),
          add_commands_(std::move(add_commands)) {}
    virtual ~Program() = default;

    const std::string& name() const { return name_; }
    const std::string& description() const { return description_; }
    void add_commands(CLI::App& app) const { add_commands_(app); }

    // Prints the error message on standard error, and returns the exit code.
    virtual int fail(int code, const std::string& message) const;
    // Prints the text of --help or --version on standard output.
    virtual void say(const std::string& text) const;

private:
    std::string name_;
    std::string description_;
    std::function<void(CLI::App&)> add_commands_;
};

// Runs the command line and returns the exit code.
int run_program(const Program& program, int argc, char** argv);

}  // namespace lacuna::cli
