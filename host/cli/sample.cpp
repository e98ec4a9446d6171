// The options of `lacuna sample`, and its run.
#include "cli/sample.h"

#include <fmt/format.h>

#include <lacuna/lacuna.h>
#include <cstdio>
#include <memory>
#include <string>

#include "cli/interruption.h"
#include "cli/observers.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/progress_bar.h"
#include "cli/report.h"
#include "cli/stopwatch.h"
#include "files/point_files.h"

namespace lacuna::cli {
namespace {

constexpr const char* kDescription =
    R"(Makes a blue-noise point set: random, evenly spread points with no room left for another.

Examples:
  lacuna sample --radius 0.01                       points as `x y` lines on standard output
  lacuna sample --radius 0.01 -o points.svg         a picture; see --output for the formats
  lacuna sample --count 10000 --torus -o points.npy exactly so many points, and edges that wrap
  lacuna sample --radius 0.02 --domain 2x1 --mode lines   the paper's algorithm
  lacuna sample --radius 0.005 --seed 7 -o a.csv --report a.json   and what it cost
)";

struct Options {
    Request request;
    std::string output = "-";
    std::string report;
    bool quiet = false;
};

void add_what_to_make(CLI::App& command, Options& options) {
    Request& request = options.request;
    add_number(command, "radius", "R", request.radius,
               "Least distance between two points; this or --count");
    add_number(command, "count", "N", request.count,
               "Exactly so many points, at a radius that fits; this or --radius");
    command
        .add_option_function<std::string>(
            "--domain",
            [&request](const std::string& text) {
                read_domain("domain", text, request.width, request.height);
            },
            "Width and height of the domain (default 1x1)")
        ->type_name("WxH");
    command
        .add_flag_callback(
            "--torus", [&request] { request.boundary = Boundary::torus; }, "The edges wrap")
        ->disable_flag_override();
    add_number(command, "limit", "K", request.limit, "Stop after so many points");
    add_number(command, "seed", "S", request.seed,
               "Same seed, same points, whatever the backend (default 0)");
}

void read_mode(const std::string& text, Mode& mode) {
    for (const Mode known : {Mode::exact, Mode::lines}) {
        if (text != name_of(known)) continue;
        mode = known;
        return;
    }
    throw BadRequest("mode", shown(text), "must be exact or lines");
}

void add_how_to_make_it(CLI::App& command, Options& options) {
    Request& request = options.request;
    command
        .add_option_function<std::string>(
            "--mode", [&request](const std::string& mode) { read_mode(mode, request.mode); },
            "exact (default): no gap is left, every distance is at least the radius; lines: as in "
            "the paper")
        ->type_name("MODE");
    add_number(command, "lines-per-radius", "M", request.lines_per_radius,
               "Lines in a radius' width (default 6 in exact, 30 in lines)");
    command
        .add_flag("--uniform-x", request.uniform_x,
                  "In lines: those with room are equally likely, however much room they have")
        ->disable_flag_override();
    command
        .add_flag("--snap", request.snap,
                  "In lines: points lie on them, and no distance is less than the radius; without, "
                  "1/(2M) of it less")
        ->disable_flag_override();
    add_number(command, "round-size", "K", request.round_size,
               "Draws in a round; 0 chooses (default), 1 is the paper's algorithm");
    command
        .add_option("--backend", request.backend,
                    "auto (default), cpu, opencl, vulkan or reference")
        ->type_name("NAME");
    command.add_option("--device", request.device, "A number or a part of the device's name")
        ->type_name("NAME");
    add_number(command, "threads", "T", request.threads, "Threads; 0 is one a core (default)");
}

void add_what_to_write(CLI::App& command, Options& options) {
    command
        .add_option("-o,--output", options.output,
                    "By extension: .txt .csv .npy .ply .json .svg .pdf .png; "
                    "- is standard output, as .txt (default)")
        ->type_name("FILE");
    command
        .add_option("--report", options.report,
                    "Request, counts, seconds by verb, memory and SHA-256 of the points")
        ->type_name("FILE.json");
    command.add_flag("--quiet", options.quiet, "No progress bar and no last line")
        ->disable_flag_override();
}

void write(const Options& options, const Result& result, const Stopwatch& stopwatch,
           double seconds) {
    const Request& request = options.request;
    const files::PointSet set{result.points, request.width, request.height, result.radius};
    files::write_whole(options.output, files::encode(set, files::format_of(options.output)));
    if (!options.report.empty())
        files::write_whole(options.report, report_of(request, result, stopwatch, seconds));
    if (options.quiet || options.output == "-") return;
    const std::string summary =
        fmt::format("{} points, {} rounds, {:.3f} s, {} -> {}\n", result.points.size(),
                    result.rounds, seconds, result.backend, options.output);
    std::fputs(summary.c_str(), stderr);
}

void run(const Options& options) {
    check_output(options.output);
    if (!options.report.empty()) check_report(options.report, options.output);

    Interruption interruption;
    Stopwatch stopwatch;
    const Result result = [&] {
        ProgressBar bar(options.quiet);
        Observers observers({interruption, stopwatch, bar});
        return sample(options.request, observers);
    }();
    const double seconds = stopwatch.seconds_so_far();
    interruption.start_writing(options.output != "-");
    write(options, result, stopwatch, seconds);
}

}  // namespace

void add_sample(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("sample", kDescription);
    const auto options = std::make_shared<Options>();
    add_what_to_make(command, *options);
    add_how_to_make_it(command, *options);
    add_what_to_write(command, *options);
    command.callback([options] { run(*options); });
}

}  // namespace lacuna::cli
