// Options and the run that `lacuna sample` and `lacuna stipple` have in common.
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

// Each adds options to `command`, which the request or `options` must outlive.
// --torus, --limit, --seed
void add_what_to_make(CLI::App& command, Request& request);
// --round-size, --threads
void add_effort(CLI::App& command, Request& request);
// --backend, --device
void add_place(CLI::App& command, Request& request);
// --output and --format
void add_point_outputs(CLI::App& command, CommonOptions& options);
// These, --report and --quiet
void add_what_to_write(CLI::App& command, CommonOptions& options);

// The outputs, checked before the work starts; without --output it is standard output. No output
// may be a file in `read`. Throws BadRequest and files::FileError.
std::vector<Output> checked_outputs(const CommonOptions& options,
                                    const std::vector<GivenFile>& read);

// A set that has been made, and the time it took.
struct Made {
    Result result;
    Stopwatch stopwatch;
    double seconds = 0;
};

// Makes the set under a progress bar. Throws what lacuna::sample throws.
Made make(const CommonOptions& options);

// Prints a line about the set on standard error, unless --quiet is given or standard output is an
// output. `what` is "point" or "dot"; `note` follows their number, and `more` the backend.
void sum_up(const CommonOptions& options, const std::vector<Output>& outputs, const Made& made,
            const std::string& what, const std::string& note = "", const std::string& more = "");

}  // namespace lacuna::cli
