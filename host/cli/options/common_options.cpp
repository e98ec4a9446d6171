// Options of both `lacuna sample` and `lacuna stipple`.
#include "cli/options/common_options.h"

#include <fmt/core.h>

#include <CLI/App.hpp>
#include <cstddef>
#include <cstdio>

#include "cli/options/class_options.h"
#include "cli/options/options.h"
#include "cli/reports/output.h"
#include "cli/terminal/driver.h"
#include "cli/terminal/observers.h"
#include "cli/terminal/progress_bar.h"

namespace lacuna::cli {

void add_what_to_make(CLI::App& command, Request& request) {
    command
        .add_flag_callback(
            "--torus", [&request] { request.boundary = Boundary::torus; }, "The edges wrap")
        ->disable_flag_override();
    add_number(command, "limit", "K", request.limit, "Stop after K points");
    add_number(
        command, "seed", "S", request.seed,
        "Same seed, same points, whatever the backend (default 0). Give each colour channel a "
        "seed of its own: where channels are equal, one seed puts their dots on the same spots");
}

void add_effort(CLI::App& command, Request& request) {
    add_number(command, "round-size", "K", request.round_size,
               "Draws in a round; 0 chooses (default), 1 is the paper's algorithm");
    add_number(command, "threads", "T", request.threads,
               "Number of threads; 0 is one for each core (default)");
}

void add_place(CLI::App& command, Request& request) {
    command
        .add_option(
            "--backend", request.backend,
            "cpu, opencl, vulkan or reference; auto (default) is the one that the environment "
            "variable LACUNA_BACKEND names, or else cpu")
        ->type_name("NAME");
    command.add_option("--device", request.device, "A device's number or a part of its name")
        ->type_name("NAME");
}

void add_point_outputs(CLI::App& command, CommonOptions& options) {
    add_outputs(command, options.output, "FILE",
                "By extension: " + files::written_extensions() +
                    "; - is standard output, as .txt (default); may be given several times");
}

void add_what_to_write(CLI::App& command, CommonOptions& options) {
    add_point_outputs(command, options);
    command
        .add_option(
            "--report", options.report,
            "Writes the request, counts, seconds by verb, memory and SHA-256 of the points; - is "
            "standard output")
        ->type_name("FILE.json");
    command
        .add_flag("--quiet", options.quiet, "No progress bar, no warning and no summary at the end")
        ->disable_flag_override();
}

std::vector<Output> checked_outputs(const CommonOptions& options,
                                    const std::vector<GivenFile>& read) {
    OutputOptions output = options.output;
    if (output.paths.empty()) output.paths.emplace_back("-");
    const std::vector<Output> outputs = outputs_of(output, files::written_extensions(), "txt");
    std::vector<GivenFile> written = given_files(outputs);
    if (!options.report.empty()) {
        check_json("report", options.report);
        written.push_back({"--report", options.report});
    }
    check_given_files(read, written);
    return outputs;
}

Made make(const CommonOptions& options) {
    Made made;
    ProgressBar bar(options.quiet);
    DriverAtWork driver(options.request.backend);
    Observers observers({driver, made.stopwatch, bar});
    made.result = sample(options.request, observers);
    made.seconds = made.stopwatch.seconds_so_far();
    return made;
}

void sum_up(const CommonOptions& options, const std::vector<Output>& outputs, const Made& made,
            const std::string& what, const std::string& note, const std::string& more) {
    if (options.quiet || has_standard_output(outputs) || is_standard_output(options.report)) return;
    const Result& result = made.result;
    // The radius or scale that was chosen for --count or for stipple's default number of dots.
    // After relaxing the radius may be 0, which means not known.
    std::string size;
    if (!options.request.radius && !options.request.scale) {
        if (!options.request.classes.names.empty())
            size = fmt::format(", distances {:.4g} times those given",
                               distance_factor(options.request, result));
        else if (result.scale > 0)
            size = fmt::format(", scale {:.4g}", result.scale);
        else if (result.radius > 0 && options.request.mode != Mode::stratified)
            size = fmt::format(", radius {:.4g}", result.radius);
    }
    if (what == "point" && !result.maximal) size += ", not maximal";
    const std::size_t count = result.points.size();
    std::string rounds;
    if (result.rounds > 0)
        rounds = fmt::format(", {} round{}", result.rounds, result.rounds == 1 ? "" : "s");
    const std::string summary =
        fmt::format("{} {}{}{}{}{}, {:.3f} s, {}{} -> {}", count, what, count == 1 ? "" : "s", note,
                    size, rounds, made.seconds, result.backend, more, paths_of(outputs));
    std::fputs((printable(summary) + "\n").c_str(), stderr);
}

}  // namespace lacuna::cli
