// The options of `lacuna relax`, and its run.
#include "cli/commands/commands.h"

#include <fmt/core.h>
#include <lacuna/lacuna.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/options/common_options.h"
#include "cli/options/domain_options.h"
#include "cli/options/drawing.h"
#include "cli/options/given_set.h"
#include "cli/options/relaxation.h"
#include "cli/reports/output.h"
#include "cli/reports/report.h"
#include "cli/terminal/interruption.h"
#include "cli/terminal/run_program.h"
#include "files/point_files.h"
#include "files/read_points.h"
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
    options::Moves moves{.iterations = RelaxOptions{}.iterations};
};

// Checks the options and returns the outputs.
std::vector<Output> check(const CommandLine& line, const RelaxCommand& options) {
    const std::vector<Output> outputs = checked_outputs(options.common, files_read(line));
    pictures::check(options.set.picture.importance);
    return outputs;
}

Json json_of(const RelaxCommand& options, const Request& request) {
    Json json{{"points", options.set.points},
              {"image",
               options.set.picture.path.empty() ? Json(nullptr) : Json(options.set.picture.path)},
              {"width", request.domain.width},
              {"height", request.domain.height}};
    if (request.domain.has_corner())
        json.update({{"x0", request.domain.x0}, {"y0", request.domain.y0}});
    json["boundary"] = request.domain.wraps() ? "torus" : "box";
    json.update(json_of_importance(options.set.picture.importance));
    json["backend"] = request.run_on.backend;
    json["device"] = request.run_on.device;
    json["threads"] = request.run_on.threads;
    return json;
}

void run(const CommandLine& line, const RelaxCommand& options) {
    const std::vector<Output> outputs = check(line, options);
    const DrawingOptions drawing = checked_drawing(line, options.drawing, outputs);
    Interruption interruption;
    CommonOptions common = options.common;
    Request& request = common.request;
    SetAndField given = read_given_set(line, options.set, request);
    const GivenColumns columns(options.set, given, drawing, outputs, false);
    const RelaxOptions moves = options::relax_options_of(request, options.moves);
    Finished made{.stopwatch = Stopwatch(!common.report.empty())};
    made.result.points = std::move(given.file.points);
    if (given.field) request.field = &*given.field;
    const Relaxation relaxation = naming_points(
        options.set, [&] { return relax_points(common, outputs, moves, request.field, made); });

    files::PointSet set{made.result.points, request.domain, made.result.radius};
    set.is_relaxed = true;
    columns.add_to(set);
    const drawing::Style style = style_of(drawing, request.domain);
    if (!common.quiet) warn_of_ink(drawing, request, request.field, set.points.size(), style);
    const std::string steps =
        options.moves.gaussian == 0 ? "" : fmt::format(", {} steps", options.moves.gaussian);
    finish(interruption, common, drawing, outputs,
           {.set = set,
            .style = style,
            .find_diameters = [&] { return dots_of(request, set.points, stippling::Spread::even); },
            .report =
                [&] { return relax_report(json_of(options, request), made, json_of(relaxation)); },
            .words = fmt::format("{} points, {} iterations{}, {:.3f} s, {}", set.points.size(),
                                 options.moves.iterations, steps, made.seconds,
                                 relaxation.relaxed.backend)});
}

// Where the value of each option goes.
Targets targets_of(RelaxCommand& all) {
    Targets targets{{"iterations", &all.moves.iterations}};
    targets.merge(targets_of(all.set));
    targets.merge(targets_of(all.common));
    targets.merge(targets_of(all.drawing));
    targets.merge(options::targets_of(all.moves));
    return targets;
}

}  // namespace

void add_relax_command(CLI::App& app) {
    const auto all = std::make_shared<RelaxCommand>();
    add_command(app, options::kRelax, kRelaxDescription, targets_of(*all),
                [all](const CommandLine& line) { run(line, *all); });
}

}  // namespace lacuna::cli
