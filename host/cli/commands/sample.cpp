// The options of `lacuna sample`, and its run.
#include "cli/commands/sample.h"

#include <fmt/core.h>
#include <lacuna/lacuna.h>

#include <CLI/App.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands/made_set.h"
#include "cli/commands/relaxation.h"
#include "cli/commands/sample_seeds.h"
#include "cli/options/class_options.h"
#include "cli/options/common_options.h"
#include "cli/options/domain_options.h"
#include "cli/options/drawing.h"
#include "cli/options/ellipse_options.h"
#include "cli/options/given_files.h"
#include "cli/options/options.h"
#include "cli/options/origin.h"
#include "cli/reports/output.h"
#include "cli/reports/report.h"
#include "cli/reports/writing.h"
#include "cli/terminal/interruption.h"
#include "files/point_files.h"
#include "recipes/settle.h"
#include "relax/descent.h"

namespace lacuna::cli {
namespace {

constexpr const char* kSampleDescription =
    R"(Makes a blue-noise point set: random points, evenly spread, with no room for one more.

Examples:
  lacuna sample --radius 0.01                       points as `x y` lines on standard output
  lacuna sample --radius 0.01 -o points.svg         a picture; see --output for the formats
  lacuna sample --count 10000 --torus -o points.npy exactly 10000 points, not maximal; edges wrap
  lacuna sample --radius 0.02 --domain 2x1 --mode lines   the paper's algorithm
  lacuna sample --count 4096 --torus --relax 30 -o even.npy   far more even: see lacuna relax --help
  lacuna sample --count 4096 --torus --relax 30 --gaussian -o smooth.npy   no low frequencies
  lacuna sample --radius 0.005 --seed 7 -o a.csv --report a.json   points, and a report of the run
  lacuna sample --count 10k --format npy > a.npy      another format on standard output
  lacuna sample --field density.png --scale 0.004 -o points.npy   dense where it is dark
  lacuna sample --inside lakes.svg --border 2 --radius 3 -o fish.svg   points within polygons
  lacuna sample --inside park.svg --outside pond.svg --radius 3 -o trees.svg   and not in others
  lacuna sample --avoid rocks.csv --avoid path.svg:2 --radius 1 -o plants.csv   around obstacles
  lacuna sample --keep trees.csv --radius 0.02 -o more.csv   fills the space around given points
  lacuna sample --class trees:0.03 --class grass:0.006 -o wood.csv   kinds of points
  lacuna sample --count 256 --torus --seeds 0..999 -o 'tiles/{seed}.npy'   a thousand small tiles
)";

struct SampleCommand {
    CommonOptions common;
    DomainOptions domain;
    DrawingOptions drawing;
    recipes::Given given;
    std::uint32_t relax = 0;  // as `given` says
    GaussianOptions gaussian;
    std::optional<SeedRange> seeds;
    bool ellipse_columns = false;
};

bool has_ellipses(const DomainOptions& options) {
    return options.ellipses.are_given() || options.field.importance.along != 1;
}

void read_mode(const std::string& text, std::optional<Mode>& mode) {
    if (text == name_of(Mode::cells))
        throw BadRequest("mode", text, "is a mode of lacuna stipple: must be exact or lines");
    for (const Mode known : {Mode::exact, Mode::lines, Mode::stratified}) {
        if (text != name_of(known)) continue;
        mode = known;
        return;
    }
    throw BadRequest("mode", shown(text), "must be exact or lines or, with --relax, stratified");
}

// Relaxing would move points to where none may lie, and would move kept points.
void check_relax(const SampleCommand& all) {
    if (all.relax == 0 && all.gaussian.steps == 0) return;
    const auto refuse = [&](const char* allowed) {
        if (all.relax != 0) throw BadRequest("relax", std::to_string(all.relax), allowed);
        throw BadRequest("gaussian", std::to_string(all.gaussian.steps), allowed);
    };
    if (all.common.request.progressive)
        refuse("cannot be used with --progressive: it moves the points");
    if (all.seeds) refuse("cannot be used with --seeds: relax each file with lacuna relax");
    if (!all.domain.mask.empty() || !all.domain.inside.empty() || !all.domain.outside.empty() ||
        !all.domain.avoid.empty() || !all.domain.keep.empty() || all.common.request.border != 0)
        refuse("cannot be used with --mask, --inside, --outside, --avoid, --border or --keep");
    if (!all.domain.classes.given.empty())
        refuse("cannot be used with --class: it keeps no distances");
    if (has_ellipses(all.domain))
        refuse("cannot be used with --ellipses, --stretch or --along: relaxing has disks");
}

void run(const CLI::App& command, SampleCommand all) {
    all.given.has_ellipses = has_ellipses(all.domain);
    all.relax = recipes::relax_of(all.given);
    all.given.gaussian = all.gaussian.steps;
    check_relax(all);
    recipes::settle(all.given, all.common.request);
    check_domain(command, all.domain);
    check_ellipse_columns(all.ellipse_columns, has_ellipses(all.domain));
    CommonOptions options = all.common;
    Request& request = options.request;
    const std::vector<GivenFile> read = files_of(all.domain);
    const std::vector<Output> outputs = all.seeds
                                            ? checked_outputs(command, options, *all.seeds, read)
                                            : checked_outputs(options, read);
    check_drawing(all.drawing, outputs);
    if (!all.domain.classes.given.empty() && !loss_of_columns(outputs).empty())
        throw BadRequest("class", shown(all.domain.classes.given.front()),
                         "the class of each point " + loss_of_columns(outputs));
    check_ellipse_columns(all.ellipse_columns, outputs);
    for (const auto& [name, size] :
         {std::pair{"radius", all.common.request.radius}, {"scale", all.common.request.scale}})
        if (size && !all.domain.classes.given.empty())
            throw BadRequest(name, fmt::format("{}", *size),
                             "is not for --class, which gives the radius of each class");
    DomainFiles files;
    read_domain_files(command, all.domain, request, files);
    const Showing showing{all.ellipse_columns, all.domain.ellipses.are_given()};
    if (all.seeds) {
        sample_seeds(command, options, all.drawing, outputs, *all.seeds,
                     {json_of(all.domain, request, files), showing});
        return;
    }
    const drawing::Style style = style_of(all.drawing, request.width, request.height);
    const RelaxOptions moves = relax_options_of(request, all.relax, all.gaussian);
    const bool moves_points = all.relax != 0 || all.gaussian.steps != 0;
    relaxing::check_gaussian(request.field, moves);
    Interruption interruption;
    Made made = make(options);
    // Reports have the distances that the set keeps, which differ from those given with a count.
    Request as_made = request;
    const double factor = distance_factor(request, made.result);
    for (double& distance : as_made.classes.distances) distance *= factor;
    Json decides = json_of(all.domain, as_made, files);
    Json more{{"request", decides}};
    if (moves_points) {
        decides.update(json_of_moves(moves));
        more.update(json_of(relax_points(options, outputs, moves, request.field, made)), true);
    }
    const files::Origin origin = origin_of(command, request, made.result, decides);
    const MadeSet set(request, made.result, origin, showing);
    const Field* const tone = showing.is_sized_by_radii ? nullptr : request.field;
    if (!options.quiet) warn_of_ink(all.drawing, request, tone, made.result.points.size(), style);
    Writing writing(interruption);
    if (!options.report.empty())
        writing.add(options.report, [&] { return report_of(request, made, more); });
    write_set(writing, all.drawing, outputs, set.points(), style, [&] {
        return set.diameters(moves_points ? drawing::Spread::even : drawing::Spread::random);
    });
    const std::size_t kept = request.keep.size();
    sum_up(options, outputs, made, "point",
           kept == 0 ? "" : ", " + std::to_string(kept) + " of them kept");
}

}  // namespace

void add_size(CLI::App& command, Request& request) {
    add_number(command, "radius", "R", request.radius,
               "Least distance between two points; this or --count");
    add_number(command, "count", "N", request.count,
               "Exactly N points, at a radius with room for a few more, so that the set is not "
               "maximal; this or --radius");
    command
        .add_option_function<std::string>(
            "--domain",
            [&request](const std::string& text) {
                read_domain("domain", text, request.width, request.height);
            },
            "Width and height of the domain (default 1x1)")
        ->type_name("WxH");
}

void add_progressive(CLI::App& command, Request& request) {
    command
        .add_flag(
            "--progressive", request.progressive,
            "Orders the points so that the first n, for any n from 16 on, are spread as evenly as "
            "a set of n points. --count may then cut the sequence anywhere")
        ->disable_flag_override();
}

void add_mode(CLI::App& command, Request& request,
              const std::function<void(const std::string&)>& read_mode,
              const std::string& more_modes) {
    command
        .add_option_function<std::string>(
            "--mode,--start", read_mode,
            "exact (default): no gap is left, every distance is at least the radius; lines: the "
            "paper's algorithm, which is approximate" +
                more_modes)
        ->type_name("MODE");
    add_number(command, "lines-per-radius", "M", request.lines_per_radius,
               "Number of lines per radius (default 6 in exact, 30 in lines)");
    command
        .add_flag("--uniform-x", request.uniform_x,
                  "In mode lines: all lines with room are equally likely, however much room they "
                  "have")
        ->disable_flag_override();
    command
        .add_flag("--snap", request.snap,
                  "In mode lines: points lie on the lines, and every distance is at least the "
                  "radius R; without it distances may be R/(2M) less")
        ->disable_flag_override();
}

void add_sample(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("sample", kSampleDescription);
    const auto options = std::make_shared<SampleCommand>();
    Request& request = options->common.request;
    add_size(command, request);
    add_domain(command, options->domain, request);
    add_what_to_make(command, request);
    add_seeds(command, options->seeds);
    add_progressive(command, request);
    add_relax(command, options->given.relax, 0);
    add_gaussian(command, options->gaussian);
    add_mode(
        command, request,
        [options](const std::string& text) { read_mode(text, options->given.mode); },
        "; stratified (default with --relax and --count): every part of the domain has its "
        "share of the points");
    add_how_to_draw(command, options->drawing, "two thirds of --radius");
    add_ellipse_columns(command, options->ellipse_columns);
    add_effort(command, request);
    add_place(command, request);
    add_what_to_write(command, options->common);
    command.callback([&command, options] { run(command, *options); });
}

}  // namespace lacuna::cli
