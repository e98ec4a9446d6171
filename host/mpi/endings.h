// How the ranks of a program end: rank 0 prints one message, and all exit with one code.
#pragma once

#include <mpi.h>

#include <functional>
#include <optional>
#include <string>

#include "cli/terminal/run_program.h"

namespace lacuna::mpi {

// Throws cli::BadUsage: the request of `rank` differs from that of rank 0.
[[noreturn]] void refuse_another_request(int rank);

// At first the ranks agree on how they end: every rank must call fail, say or join. If ranks fail,
// the message and exit code of the lowest one count. If all ranks call say, rank 0's text is
// printed; if only some of them do, all throw cli::BadUsage. Between part() and meet() ranks do not
// agree: a rank that fails prints its own message and ends all others.
class MpiProgram : public cli::Program {
public:
    MpiProgram(std::string name, std::string description,
               std::function<void(CLI::App&)> add_commands)
        : Program(std::move(name), std::move(description), std::move(add_commands)) {}

    int fail(int code, const std::string& message) const override;
    void say(const std::string& text) const override;

    // Returns if all ranks call join. Otherwise, after the message, throws cli::CheckFailed.
    void join() const;
    void part() const { are_together_ = false; }
    void meet() const { are_together_ = true; }

    // The exit code of the process after run_program has returned `returned`.
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
