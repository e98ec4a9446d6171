// How the ranks of a program end: with one message, by rank 0, and one exit code.
#pragma once

#include <mpi.h>

#include <functional>
#include <optional>
#include <string>

#include "cli/terminal/run_program.h"

namespace lacuna::mpi {

// While `are_together`, as they are at first, an end is agreed upon: all ranks must come to fail,
// say or join, each in its own way, and the lowest that fails or says something is heard. Once they
// are not, a rank that fails tells so itself and ends all others.
class MpiProgram : public cli::Program {
public:
    MpiProgram(std::string name, std::string description,
               std::function<void(CLI::App&)> add_commands)
        : Program(std::move(name), std::move(description), std::move(add_commands)) {}

    int fail(int code, const std::string& message) const override;
    void say(const std::string& text) const override;

    // Goes on if all ranks do; else throws cli::CheckFailed, with all said.
    void join() const;
    void part() const { are_together_ = false; }
    void meet() const { are_together_ = true; }

    // What to exit with, where run_program returned this.
    int exit_code(int returned) const { return agreed_code_.value_or(returned); }

private:
    struct Ending {
        int code = 0;
        int is_answer = 0;
        std::string text;
    };
    void end_with(const std::optional<Ending>& own) const;

    mutable bool are_together_ = true;
    mutable std::optional<int> agreed_code_;
};

}  // namespace lacuna::mpi
