// What `lacuna sample` and `lacuna stipple` have in common: options, and the run itself.
#pragma once

#include <lacuna/lacuna.h>

#include <string>

#include "cli/app_fwd.h"
#include "cli/interruption.h"
#include "cli/stopwatch.h"

namespace lacuna::cli {

struct CommonOptions {
    Request request;
    std::string output = "-";
    std::string report;
    bool quiet = false;
};

// Adds the options to `command`; what they are written to must outlive it.
// --torus, --limit, --seed
void add_what_to_make(CLI::App& command, Request& request);
// --round-size, --threads
void add_effort(CLI::App& command, Request& request);
// --backend, --device
void add_place(CLI::App& command, Request& request);
// --output, --report, --quiet
void add_what_to_write(CLI::App& command, CommonOptions& options);

// Checks the paths of what is to be written, before the work starts. Throws BadRequest and
// files::FileError.
void check_paths(const CommonOptions& options);

// A set that has been made, and what it took.
struct Made {
    Result result;
    Stopwatch stopwatch;
    double seconds = 0;
};

// Makes the set under a progress bar. Throws what lacuna::sample throws.
Made make(const CommonOptions& options, Interruption& interruption);

// Prints the last line, on standard error, unless it is not wanted or the data went to standard
// output: `what` has been made, `more` is added to it.
void sum_up(const CommonOptions& options, const Made& made, const char* what,
            const std::string& more = "");

}  // namespace lacuna::cli
