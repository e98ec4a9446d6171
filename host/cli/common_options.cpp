// Options that both makers of point sets have.
#include "cli/common_options.h"

#include <fmt/core.h>

#include <CLI/App.hpp>
#include <cstdio>

#include "cli/observers.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/progress_bar.h"

namespace lacuna::cli {

void add_what_to_make(CLI::App& command, Request& request) {
    command
        .add_flag_callback(
            "--torus", [&request] { request.boundary = Boundary::torus; }, "The edges wrap")
        ->disable_flag_override();
    add_number(command, "limit", "K", request.limit, "Stop after so many points");
    add_number(command, "seed", "S", request.seed,
               "Same seed, same points, whatever the backend (default 0)");
}

void add_effort(CLI::App& command, Request& request) {
    add_number(command, "round-size", "K", request.round_size,
               "Draws in a round; 0 chooses (default), 1 is the paper's algorithm");
    add_number(command, "threads", "T", request.threads, "Threads; 0 is one a core (default)");
}

void add_place(CLI::App& command, Request& request) {
    command
        .add_option("--backend", request.backend,
                    "auto (default), cpu, opencl, vulkan or reference")
        ->type_name("NAME");
    command.add_option("--device", request.device, "A number or a part of the device's name")
        ->type_name("NAME");
}

void add_what_to_write(CLI::App& command, CommonOptions& options) {
    command
        .add_option("-o,--output", options.output,
                    "By extension: " + files::written_extensions() +
                        "; - is standard output, as .txt (default)")
        ->type_name("FILE");
    command
        .add_option("--report", options.report,
                    "Request, counts, seconds by verb, memory and SHA-256 of the points")
        ->type_name("FILE.json");
    command.add_flag("--quiet", options.quiet, "No progress bar and no last line")
        ->disable_flag_override();
}

void check_paths(const CommonOptions& options) {
    check_output(options.output);
    if (!options.report.empty()) check_json("report", options.report, options.output);
}

Made make(const CommonOptions& options, Interruption& interruption) {
    Made made;
    ProgressBar bar(options.quiet);
    Observers observers({interruption, made.stopwatch, bar});
    made.result = sample(options.request, observers);
    made.seconds = made.stopwatch.seconds_so_far();
    return made;
}

void sum_up(const CommonOptions& options, const Made& made, const char* what,
            const std::string& more) {
    if (options.quiet || options.output == "-") return;
    const std::string summary =
        fmt::format("{} {}, {} rounds, {:.3f} s, {}{} -> {}\n", made.result.points.size(), what,
                    made.result.rounds, made.seconds, made.result.backend, more, options.output);
    std::fputs(summary.c_str(), stderr);
}

}  // namespace lacuna::cli
