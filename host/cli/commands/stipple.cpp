// The options of `lacuna stipple`, and its run.
#include "cli/commands/stipple.h"

#include <fmt/core.h>

#include <lacuna/lacuna.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands/relaxation.h"
#include "cli/commands/stipple_work.h"
#include "cli/options/common_options.h"
#include "cli/options/ellipse_options.h"
#include "cli/options/options.h"
#include "cli/options/origin.h"
#include "cli/reports/output.h"
#include "cli/reports/report.h"
#include "cli/reports/writing.h"
#include "cli/terminal/interruption.h"
#include "cli/terminal/stopwatch.h"
#include "drawing/picture.h"
#include "drawing/tones.h"
#include "files/point_files.h"
#include "pictures/importance.h"

namespace lacuna::cli {
namespace {

constexpr const char* kStippleDescription =
    R"(Stipples a picture: random dots, evenly spread, dense where it is dark.

Examples:
  lacuna stipple photo.jpg -o dots.svg                       a number of dots that suits the picture
  lacuna stipple photo.jpg --count 20000 -o dots.svg         exactly 20000 dots
  lacuna stipple dim.jpg --auto-levels -o dots.svg -o dots.png   an underexposed photo, two files
  lacuna stipple photo.jpg --inks cmyk -o dots.svg -o dots.png    in four inks, a layer for each
  lacuna stipple photo.jpg --count 2000 --size-by-tone 0.5 --sharpen 8 -o dots.svg   few dots
  lacuna stipple photo.jpg --along 4 -o hairs.svg             short strokes along the edges
  lacuna stipple photo.jpg --scale 0.003 -o dots.png         as many as there is room for
  lacuna stipple photo.jpg --count 20000 --relax 0 -o dots.pdf        the paper's set, grainy
  lacuna stipple photo.jpg --scale 0.003 --relax 0 --mode exact -o dots.npy   no gap is left
  lacuna stipple photo.jpg --dot-size 0.5mm --paper-size A6 --margin 8mm --pen-path -o plot.svg
                                                             for a plotter with a pen of 0.5 mm
  lacuna stipple density.npy --invert --count 5000 > points.txt       high numbers are dense

The domain is the picture, with a longer side of 1 and y upwards. Importance is 1 where the picture
is black and 0, which means no dots, where it is white. Dots are placed at random, so that every
part of the picture has its share of them. Then --relax moves them K times, until their cells hold
equal darkness and each dot is in the middle of its cell.

With --relax 0 dots are not moved, and are at least a radius apart; the radius is
G / sqrt(importance). Points come in the order in which they were admitted: any prefix keeps these
distances, but has gaps. Where radii differ, --metric min (default) keeps two dots at least the
smaller radius apart, so that dots in light areas take no room from dark areas. With mean and max
they do, and gaps remain along edges of the picture.

With --mode cells dots are placed on a lattice, and about 4 % fewer fit than in the plane. With
--mode exact they are placed in the plane and no gap is left: the set of lacuna sample --field.
Either may be relaxed, too; cells then has --metric mean by default. Shapes that are smaller than a
dot's cell get more dots than their share that way.

With --dot-size 0.5mm all dots are equally large, as a pen draws them, and with 0.3mm..0.8mm they
are larger where it is darker. Without --count there are as many as give the picture's ink. A line
warns of less than half of that ink or more than twice. Without --dot-size, --size-by-tone lets
sizes vary.

With --along 4 dots are ellipses, up to four times as long as wide, along the picture's edges: a set
of --mode exact with --relax 0.

With --inks the picture's colours are separated, in linear light, and the dots of each ink are even,
and all dots together are. Files have them ink by ink.

With --paper-size the picture lies in the middle of the paper, as large as --margin allows, and .svg
is in mm. Without it the page is the picture, and 512pt long.

Formats read are PNG, JPEG, PGM, PPM, PFM, Radiance HDR and NumPy's .npy. For photos that are too
dark or too light as a whole use --auto-levels.
)";

void read_dot_mode(const std::string& text, std::optional<Mode>& mode) {
    for (const Mode known : {Mode::stratified, Mode::cells, Mode::exact}) {
        if (text != name_of(known)) continue;
        mode = known;
        return;
    }
    throw BadRequest("mode", shown(text), "must be stratified, cells or exact");
}

void add_what_to_stipple(CLI::App& command, StippleCommand& options) {
    Request& request = options.common.request;
    add_picture(command, options.picture, request)->required();
    add_number(
        command, "count", "N", request.count,
        "Exactly N dots, at a scale that fits; this or --scale (default: a number that suits the "
        "picture's size and darkness, or --dot-size)");
    command
        .add_option_function<std::string>(
            "--mode,--start",
            [&options](const std::string& mode) { read_dot_mode(mode, options.given.mode); },
            "How dots are placed before they are moved. stratified (default with --relax): every "
            "part of the picture has its share of the dots; cells (default with --relax 0): on a "
            "lattice, as in the paper; exact: in the plane, with no gap left, and with --metric "
            "min. With --scale, --metric, --limit, --lines-per-radius or --round-size, which are "
            "about distances, the default is cells, too")
        ->type_name("MODE");
    add_number(command, "lines-per-radius", "M", request.lines_per_radius,
               "Lattice steps per least radius (default 10); in exact it changes only the speed "
               "(default 1)");
}

void add_size_by_tone(CLI::App& command, StippleCommand& options) {
    add_number(command, "size-by-tone", "A", options.size_by_tone,
               "How much of the tone is in the dots' sizes, 0 to 1 (default 0: all are equally "
               "large). Areas are proportional to importance^A, and dots as dense as "
               "importance^(1 - A): with few dots more is seen");
}

void add_keep_inside(CLI::App& command, StippleCommand& options) {
    command
        .add_flag("--keep-inside", options.keep_inside,
                  "Keeps dots off white, and in the picture: dots that overhang an edge are moved "
                  "inwards, and in a shape narrower than a dot they are made smaller, but not "
                  "smaller than a pen. Where the picture is black no gaps are left")
        ->disable_flag_override();
}

void add_pen_path(CLI::App& command, StippleCommand& options) {
    command
        .add_flag("--pen-path", options.pen_path,
                  "Orders the dots along a short path for a pen, in every format")
        ->disable_flag_override();
}

std::string names_of(const std::vector<Ink>& inks) {
    std::string names;
    for (const Ink& ink : inks) names += (names.empty() ? "" : ",") + ink.name;
    return names;
}

bool has_ellipses(const StippleCommand& options) {
    return options.picture.importance.along != 1;
}

// Ellipses are for mode exact, and are not relaxed.
void check_ellipses(const StippleCommand& options) {
    check_ellipse_columns(options.ellipse_columns, has_ellipses(options));
    if (!has_ellipses(options)) return;
    const auto refuse = [&](const char* allowed) {
        throw BadRequest("along", fmt::format("{}", options.picture.importance.along), allowed);
    };
    if (!options.inks.inks.empty()) refuse("is not for --inks, whose dots are relaxed");
    if (options.given.relax.value_or(0) != 0)
        refuse("cannot be used with --relax: relaxing has disks");
    if (options.given.mode.value_or(Mode::exact) != Mode::exact) refuse("is for --mode exact");
}

// Decides what was not given.
StippleCommand settled(StippleCommand options) {
    const bool has_inks = !options.inks.inks.empty();
    check_ellipses(options);
    check_inks(options.inks, options.common.request, options.given.mode);
    if (has_inks && options.picture.metric)
        throw BadRequest("metric", std::string(name_of(*options.picture.metric)),
                         "is not for --inks, whose dots begin stratified");
    options.given.has_inks = has_inks;
    options.given.has_ellipses = has_ellipses(options);
    options.given.metric = options.picture.metric;
    options.relax = recipes::relax_of(options.given);
    recipes::settle(options.given, options.common.request);
    return options;
}

// Checks everything that can be checked before the picture is read; returns the outputs.
std::vector<Output> check_options(const StippleCommand& options) {
    const std::vector<Output> outputs =
        checked_outputs(options.common, {{"IMAGE", options.picture.path}});
    pictures::check(options.picture.importance);
    check_drawing(options.drawing, outputs);
    check_ellipse_columns(options.ellipse_columns, outputs);
    if (!options.inks.inks.empty() && !loss_of_columns(outputs).empty())
        throw BadRequest("inks", names_of(options.inks.inks),
                         "the ink of each dot " + loss_of_columns(outputs));
    if (!(options.size_by_tone >= 0 && options.size_by_tone <= 1))
        throw BadRequest("size-by-tone", fmt::format("{}", options.size_by_tone), "must be 0 to 1");
    if (options.size_by_tone != 0 && options.drawing.pens)
        throw BadRequest("size-by-tone", fmt::format("{}", options.size_by_tone),
                         "is not for a --dot-size in mm; give two, such as 0.3mm..0.8mm");
    return outputs;
}

// Sets the number of dots, in all and of each ink. Returns what is to be said of it.
std::string choose_count(const StippleCommand& options, drawing::Tones& tones, Request& request,
                         const drawing::Style& style) {
    std::string note;
    if (!request.count && !request.scale && options.inks.counts.empty()) {
        request.count = drawing::suiting_count(tones, request.width, request.height, style);
        note = " (chosen for the picture: --count gives another number)";
    }
    if (!tones.has_inks()) return note;
    share_dots(tones, options.inks, request);
    return fmt::format(" ({})", counts_text(tones));
}

Made make(const CommonOptions& common, const std::vector<Output>& outputs,
          const drawing::Tones& tones, std::uint32_t iterations, Work& work) {
    const RelaxOptions relaxing = relax_options_of(common.request, iterations);
    if (tones.has_inks()) {
        Made made;
        work.relaxation = place_inks(common, outputs, drawing::parts_of(tones), relaxing, made);
        return made;
    }
    Made made = make(common);
    if (iterations != 0)
        work.relaxation = relax_points(common, outputs, relaxing, common.request.field, made);
    return made;
}

void run(const CLI::App& command, const StippleCommand& given) {
    const StippleCommand options = settled(given);
    const std::vector<Output> outputs = check_options(options);
    Work work;
    const Stopwatch stopwatch;
    CommonOptions common = options.common;
    Request& request = common.request;
    drawing::Tones tones{
        .sizing = {options.size_by_tone, options.drawing.pens},
        .keep_inside = options.keep_inside,
        .spread = options.relax != 0 ? drawing::Spread::even : drawing::Spread::random};
    read_tones(options.picture, options.inks, tones, request);
    request.field = tones.has_inks() ? &tones.sum : &tones.densities().front();
    drawing::Style style = style_of(options.drawing, request.width, request.height);
    style.for_a_pen = options.pen_path;
    const std::string note = choose_count(options, tones, request, style);
    work.read_seconds = stopwatch.seconds_so_far();

    Interruption interruption;
    Made made = make(common, outputs, tones, options.relax, work);
    if (options.keep_inside) {
        files::PointSet dots{made.result.points, request.width, request.height};
        drawing::pull_inside(tones, dots, request.boundary, style, made.result.points);
        const auto least = measure_moved(common, outputs, relax_options_of(request, 0), made);
        if (work.relaxation) work.relaxation->least_distance = least;
    }
    if (options.pen_path) order_for_a_pen(options, tones.layers, made, work);
    if (!common.quiet && !(tones.has_inks() && tones.sizing.varies()))
        warn_of_ink(options.drawing, request, &tones.all(), made.result.points.size(), style);

    const files::Origin origin = origin_of(command, request, made.result, json_of(options));
    files::PointSet set{made.result.points, request.width, request.height, made.result.radius,
                        &origin};
    set.layers = tones.layers;
    const std::vector<Ellipse> ellipses = ellipses_of(request, made.result);
    set.ellipses = ellipses;
    set.writes_ellipses = options.ellipse_columns;
    Writing writing(interruption);
    if (!common.report.empty())
        writing.add(common.report, [&] {
            return report_of(request, made,
                             report_of_the_rest(options, outputs, tones.all(), style, work));
        });
    write_set(writing, options.drawing, outputs, set, style,
              [&] { return drawing::diameters_of(tones, set, request.boundary, style); });
    sum_up(common, outputs, made, "dot", note, path_text(options, outputs, set, style, work));
}

}  // namespace

void add_stipple(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("stipple", kStippleDescription);
    const auto options = std::make_shared<StippleCommand>();
    add_what_to_stipple(command, *options);
    add_inks(command, options->inks);
    add_what_to_make(command, options->common.request);
    add_relax(command, options->given.relax, recipes::relax_of(options->given));
    add_how_to_draw(command, options->drawing,
                    "the ink of all dots is as much as the picture is dark", true);
    add_ellipse_columns(command, options->ellipse_columns);
    add_size_by_tone(command, *options);
    add_keep_inside(command, *options);
    add_pen_path(command, *options);
    add_effort(command, options->common.request);
    add_place(command, options->common.request);
    add_what_to_write(command, options->common);
    command.callback([&command, options] { run(command, *options); });
}

}  // namespace lacuna::cli
