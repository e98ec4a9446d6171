// The options of `lacuna relax`, and its run.
#include "cli/commands/relax.h"

#include <fmt/core.h>
#include <lacuna/lacuna.h>

#include <CLI/App.hpp>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands/given_set.h"
#include "cli/commands/relaxation.h"
#include "cli/options/common_options.h"
#include "cli/options/domain_options.h"
#include "cli/options/drawing.h"
#include "cli/options/options.h"
#include "cli/options/picture_field.h"
#include "cli/reports/output.h"
#include "cli/reports/report.h"
#include "cli/reports/writing.h"
#include "cli/terminal/interruption.h"
#include "files/point_files.h"
#include "files/read_sets.h"
#include "pictures/importance.h"

namespace lacuna::cli {
namespace {

constexpr const char* kRelaxDescription =
    R"(Moves points until their cells are equally large and each point is in the middle of its cell.

Examples:
  lacuna relax points.txt --torus -o even.npy           any set, on a domain whose edges wrap
  lacuna relax points.txt --domain 2x1 --iterations 30 -o even.svg --report even.json
  lacuna relax dots.npy photo.jpg -o dots.svg           cells of equal darkness, as stipple --relax
  lacuna sample --count 4096 --torus | lacuna relax - --torus -o even.txt
  lacuna relax points.txt --torus --gaussian -o smooth.npy   no low frequencies, for integrals

Cells have equal area or, with a picture, equal darkness. 10 to 30 iterations are enough; with many
more the points begin to look like a lattice. Every backend and any number of threads give the same
points, in the order given. No least distance is promised. No dot lies where the picture is white.
--gaussian goes on from there, on domains without a picture: 150 steps take the power of low
frequencies from about 1e-3 to 1e-9 or less, and usually keep 0.83 of the greatest least distance.

Without --domain and --torus the domain comes from a .json, or is the picture's shape with a longer
side of 1, or 1x1. Points are read as by analyze, and pictures as by stipple.

Exit code: 0 done, 2 bad usage, 3 a file cannot be read or written, 4 no such backend, 130
interrupted.
)";

struct RelaxCommand {
    CommonOptions common;
    GivenSet set;
    DrawingOptions drawing;
    std::uint32_t iterations = RelaxOptions{}.iterations;
    GaussianOptions gaussian;
};

// Checks the options and returns the outputs.
std::vector<Output> check(const RelaxCommand& options) {
    const std::vector<Output> outputs = checked_outputs(options.common, files_of(options.set));
    pictures::check(options.set.picture.importance);
    check_drawing(options.drawing, outputs);
    return outputs;
}

Json json_of(const RelaxCommand& options, const Request& request) {
    Json json{{"points", options.set.points},
              {"image",
               options.set.picture.path.empty() ? Json(nullptr) : Json(options.set.picture.path)},
              {"width", request.width},
              {"height", request.height},
              {"boundary", request.boundary == Boundary::torus ? "torus" : "box"}};
    json.update(json_of_importance(options.set.picture.importance));
    json["backend"] = request.backend;
    json["device"] = request.device;
    json["threads"] = request.threads;
    return json;
}

void sum_up(const RelaxCommand& options, const std::vector<Output>& outputs, const Made& made,
            const Relaxation& relaxation) {
    const CommonOptions& common = options.common;
    if (common.quiet || has_standard_output(outputs) || is_standard_output(common.report)) return;
    const std::string steps =
        options.gaussian.steps == 0 ? "" : fmt::format(", {} steps", options.gaussian.steps);
    const std::string summary = fmt::format(
        "{} points, {} iterations{}, {:.3f} s, {} -> {}", made.result.points.size(),
        options.iterations, steps, made.seconds, relaxation.relaxed.backend, paths_of(outputs));
    std::fputs((printable(summary) + "\n").c_str(), stderr);
}

void run(const RelaxCommand& options) {
    const std::vector<Output> outputs = check(options);
    Interruption interruption;
    CommonOptions common = options.common;
    Request& request = common.request;
    SetAndField given = read_given_set(options.set, request);
    const GivenColumns columns(options.set, given, options.drawing, outputs, false);
    const RelaxOptions moves = relax_options_of(request, options.iterations, options.gaussian);
    Made made;
    made.result.points = std::move(given.points);
    if (given.field) request.field = &*given.field;
    const Relaxation relaxation = naming_points(
        options.set, [&] { return relax_points(common, outputs, moves, request.field, made); });

    files::PointSet set{made.result.points, request.width, request.height, made.result.radius};
    set.boundary = request.boundary;
    set.is_relaxed = true;
    columns.add_to(set);
    const drawing::Style style = style_of(options.drawing, request.width, request.height);
    if (!common.quiet)
        warn_of_ink(options.drawing, request, request.field, set.points.size(), style);
    Writing writing(interruption);
    if (!common.report.empty())
        writing.add(common.report, [&] {
            return relax_report(json_of(options, request), made, json_of(relaxation));
        });
    write_set(writing, options.drawing, outputs, set, style,
              [&] { return dots_of(request, set.points, drawing::Spread::even); });
    sum_up(options, outputs, made, relaxation);
}

void add_options(CLI::App& command, RelaxCommand& options) {
    Request& request = options.common.request;
    add_given_set(command, options.set, request);
    add_number(
        command, "iterations", "K", options.iterations,
        fmt::format("Times that points are moved, at most 10000 (default {})", options.iterations));
    add_gaussian(command, options.gaussian);
    add_importance(command, options.set.picture, false);
    add_how_to_draw(command, options.drawing,
                    "dots have as much ink as the picture is dark, or are two thirds of the least "
                    "distance wide");
    add_number(command, "threads", "T", request.threads,
               "Number of threads; 0 is one for each core (default)");
    add_place(command, request);
    add_what_to_write(command, options.common);
}

}  // namespace

void add_relax_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("relax", kRelaxDescription);
    const auto options = std::make_shared<RelaxCommand>();
    add_options(command, *options);
    command.callback([options] { run(*options); });
}

}  // namespace lacuna::cli
