// Options and the run that `lacuna sample` and `lacuna stipple` have in common.
#pragma once

#include <lacuna/lacuna.h>

#include <string>
#include <vector>

#include "cli/options/bind.h"
#include "cli/options/given_files.h"
#include "cli/reports/output.h"
#include "cli/terminal/observers.h"

namespace lacuna::cli {

struct CommonOptions {
    Request request;
    OutputOptions output;
    std::string report;
    bool quiet = false;
};

// The targets of the options of outputs, and of a request and its outputs.
Targets targets_of(OutputOptions& output);
Targets targets_of(CommonOptions& options);

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
