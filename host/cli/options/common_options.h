// Options that several commands have, their outputs, and the run of `lacuna sample`.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/options/bind.h"
#include "cli/options/given_files.h"
#include "cli/reports/output.h"
#include "cli/terminal/driver.h"
#include "cli/terminal/observers.h"
#include "cli/terminal/progress_bar.h"
#include "files/point_files.h"
#include "options/make.h"
#include "pictures/importance.h"

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

// A picture on the command line, as the field of a request.
struct Picture {
    std::string path;
    pictures::Importance importance;
    std::optional<Metric> metric;
};

// The targets of --metric and of the options that say how a picture is read.
Targets targets_of(Picture& picture);

// Reads the picture. Throws BadRequest and files::FileError.
Field read_field(const Picture& picture);

// The outputs, checked before the work starts; without --output it is standard output. No output
// may be a file in `read`. Throws BadRequest and files::FileError.
std::vector<Output> checked_outputs(const CommonOptions& options,
                                    const std::vector<GivenFile>& read);

// A set that has been made, and the time it took.
struct Finished {
    Result result{};
    Stopwatch stopwatch;  // times verbs if there is a report
    double seconds = 0;
    std::optional<Relaxed> relaxed{};  // how the points were moved, without the points
};

// Returns work(observer), under a progress bar and with the driver of the backend watched. Sets the
// time that the run has taken.
template <class Work>
auto watched(const CommonOptions& options, Finished& made, const Work& work) {
    ProgressBar bar(options.quiet);
    DriverAtWork driver(options.request.run_on.backend);
    Observers observers({driver, made.stopwatch, bar});
    auto done = work(observers);
    made.seconds = made.stopwatch.seconds_so_far();
    return done;
}

// Makes the set under a progress bar. Evenness is measured if there is a report. Throws what
// options::make throws.
Finished make(const CommonOptions& options, options::Moves moves);

// How many points there are of each class or ink, for the note of words_of(): " (trees 20,
// grass 41)". Empty without layers.
std::string words_of(std::span<const files::Layer> layers);

// A line about the set. `what` is "point" or "dot"; `note` follows their number, and `more` the
// backend.
std::string words_of(const CommonOptions& options, const Finished& made, const std::string& what,
                     const std::string& note = "", const std::string& more = "");

// The same for a set of `count` points or dots.
std::string words_of(std::size_t count, const std::string& what, std::uint64_t rounds,
                     const std::string& note, double seconds, const std::string& backend);

}  // namespace lacuna::cli
