// The options of `lacuna sample`, and its run.
#include "base/number_text.h"
#include "checks/classes.h"
#include "cli/commands/commands.h"
#include "cli/commands/sample_space.h"

#include <fmt/core.h>
#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/options/common_options.h"
#include "cli/options/domain_options.h"
#include "cli/options/drawing.h"
#include "cli/options/given_files.h"
#include "cli/options/relaxation.h"
#include "cli/options/sample_seeds.h"
#include "cli/reports/made_set.h"
#include "cli/reports/output.h"
#include "cli/reports/report.h"
#include "cli/terminal/interruption.h"
#include "files/point_files.h"
#include "options/settle.h"
#include "pictures/importance.h"

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
  lacuna sample --domain 448000,5411000+2000x1500 --radius 20 -o map.csv   a part of a map, in metres
  lacuna sample --inside lakes.svg --border 2 --radius 3 -o fish.svg   points within polygons
  lacuna sample --inside park.svg --outside pond.svg --radius 3 -o trees.svg   and not in others
  lacuna sample --avoid rocks.csv --avoid path.svg:2 --radius 1 -o plants.csv   around obstacles
  lacuna sample --on-pixels 512x80 --count 5000 -o mask.png   on pixels, one on each at most
  lacuna sample --keep trees.csv --radius 0.02 -o more.csv   fills the space around given points
  lacuna sample --class trees:0.03 --class grass:0.006 -o wood.csv   kinds of points
  lacuna sample --class trees:0.03 --class grass:0.006 --priority -o wood.csv   trees before grass
  lacuna sample --chunk 3,-2 --chunk-size 1 --radius 0.02 -o chunk.csv   a part of an endless plane
  lacuna sample --on bunny.ply --radius 0.01 -o points.ply   on the surface of a mesh, with normals
  lacuna sample --domain 1x1x1 --torus --radius 0.02 -o volume.npy   in a volume
  lacuna sample --count 256 --torus --seeds 0..999 -o 'tiles/{seed}.npy'   a thousand small tiles
  lacuna sample --radius 0.05 --torus --frame 0.1 --seeds 0..199 -o 't/{seed}.csv'   any two fit
)";

struct SampleCommand {
    CommonOptions common;
    options::InSpace space{common.request};
    DomainOptions domain;
    DrawingOptions drawing;
    options::Choices given;
    options::Moves moves;  // the iterations as `given` says
    std::optional<SeedRange> seeds;
    std::optional<double> frame;
    bool ellipse_columns = false;
    std::string columns;
};

bool has_ellipses(const DomainOptions& options) {
    return options.ellipses.are_given() || options.field.importance.along != 1;
}

void run(const CommandLine& line, SampleCommand all) {
    if (all.space.is_asked_for())
        return sample_in_space(line, all.common, all.space, all.domain.keep);
    all.given.has_ellipses = has_ellipses(all.domain);
    all.given.has_domain = line.has("domain");
    all.moves.iterations = options::relax_of(all.given);
    all.given.gaussian = all.moves.gaussian;
    options::settle(all.given, all.common.request);
    pictures::check(all.domain.field.importance);
    CommonOptions options = all.common;
    Request& request = options.request;
    const std::vector<GivenFile> read = files_read(line);
    if (!all.seeds) refuse_seed_in(options.output.paths, options.report);
    const std::vector<Output> outputs =
        all.seeds ? checked_outputs(options, *all.seeds, read) : checked_outputs(options, read);
    all.drawing = checked_drawing(line, all.drawing, outputs);
    if (!all.domain.classes.given.empty() && !loss_of_columns(outputs).empty())
        throw BadRequest("class", shown(all.domain.classes.given.front()),
                         "the class of each point " + loss_of_columns(outputs));
    check_ellipse_columns(all.ellipse_columns, outputs);
    DomainFiles files;
    read_domain_files(line, all.domain, request, files);
    if (!options.quiet) std::fputs(files.hint.c_str(), stderr);
    if (has_sizes(request.classes) && all.drawing.are_given && !are_pictures(outputs))
        throw BadRequest("class", "of several sizes",
                         "files have their radii in the column that dots have, too: give "
                         "--dot-size, --paper-size and --dpi for pictures alone");
    const Showing showing{all.ellipse_columns, all.domain.ellipses.are_given(),
                          read_columns(all.columns, outputs)};
    if (all.seeds) {
        sample_seeds(line, options, all.drawing, outputs, *all.seeds,
                     {[&](const Request& one) { return json_of(all.domain, one, files); }, showing,
                      all.frame});
        return;
    }
    const drawing::Style style = style_of(all.drawing, request.domain);
    const RelaxOptions moves = options::relax_options_of(request, all.moves);
    const bool moves_points = all.moves.are_asked_for();
    Interruption interruption;
    Finished made = make(options, all.moves);
    const Request made_request = as_made(request, made.result);
    Json decides = json_of(all.domain, made_request, files);
    Json more{{"request", decides}};
    if (moves_points) {
        decides.update(json_of_moves(moves));
        Relaxation relaxation{moves, *made.relaxed, std::nullopt};
        if (!says_distances(options, outputs))
            made.result.radius = 0;
        else if (made.result.points.size() > 1)
            relaxation.least_distance = made.result.radius;
        more.update(json_of(relaxation), true);
    }
    const files::Origin origin = origin_of(line, request, made.result, decides);
    const MadeSet set(request, made.result, origin, showing);
    const Field* const tone = showing.is_sized_by_radii ? nullptr : request.field;
    if (!options.quiet) warn_of_ink(all.drawing, request, tone, made.result.points.size(), style);
    const auto spread = moves_points ? stippling::Spread::even : stippling::Spread::random;
    finish(interruption, options, all.drawing, outputs,
           {.set = set.points(),
            .style = style,
            .find_diameters = [&] { return set.diameters(spread); },
            .report = [&] { return report_of(request, made, more); },
            .words = words_of(options, made, "point",
                              words_of(set.points().layers) + words_of_places(made_request))});
}

void take_seeds(const std::string& text, std::optional<SeedRange>& seeds) {
    seeds = read_seeds(text);
}

// Where the value of each option goes.
Targets targets_of(SampleCommand& all) {
    Targets targets{{"seeds", take_by<take_seeds>(all.seeds)},
                    {"frame", &all.frame},
                    {"mode", &all.given.mode},
                    {"relax", &all.given.relax},
                    {"ellipse-columns", &all.ellipse_columns},
                    {"columns", &all.columns}};
    targets.merge(options::targets_of(all.domain.chunk));
    // merge() keeps the first target of a name: --border is read as texts, which may be NAME:D, and
    // --domain may have three sides.
    targets.merge(options::targets_of(all.space));
    targets.merge(targets_of(all.domain));
    targets.merge(targets_of(all.common));
    targets.merge(targets_of(all.drawing));
    targets.merge(options::targets_of(all.moves));
    return targets;
}

}  // namespace

void add_sample(CLI::App& app) {
    const auto all = std::make_shared<SampleCommand>();
    add_command(app, options::kSample, kSampleDescription, targets_of(*all),
                [all](const CommandLine& line) { run(line, *all); });
}

}  // namespace lacuna::cli
