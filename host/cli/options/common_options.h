// What `lacuna sample` and `lacuna stipple` have in common: options, and the run itself.
#pragma once

#include <lacuna/lacuna.h>

#include <string>
#include <vector>

#include "cli/app_fwd.h"
#include "cli/options/given_files.h"
#include "cli/reports/output.h"
#include "cli/terminal/stopwatch.h"

namespace lacuna::cli {

struct CommonOptions {
    Request request;
    OutputOptions output;
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
// --output, --format, --report, --quiet
void add_what_to_write(CLI::App& command, CommonOptions& options);

// What is to be written, checked before the work starts; without --output standard output. Nothing
// of `read` may be among it. Throws BadRequest and files::FileError.
std::vector<Output> checked_outputs(const CommonOptions& options,
                                    const std::vector<GivenFile>& read);

// A set that has been made, and what it took.
struct Made {
    Result result;
    Stopwatch stopwatch;
    double seconds = 0;
};

// Makes the set under a progress bar. Throws what lacuna::sample throws.
Made make(const CommonOptions& options);

// Prints the last line, on standard error, unless it is not wanted or the data went to standard
// output: points or dots, as `what` says in the singular, have been made. `note` is said of their
// number, `more` at the end.
void sum_up(const CommonOptions& options, const std::vector<Output>& outputs, const Made& made,
            const std::string& what, const std::string& note = "", const std::string& more = "");

}  // namespace lacuna::cli
