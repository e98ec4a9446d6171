// The options of `lacuna stipple`, and its run.
#include "cli/commands/stipple.h"

#include <fmt/core.h>

#include <lacuna/lacuna.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands/relaxation.h"
#include "cli/options/common_options.h"
#include "cli/options/drawing.h"
#include "cli/options/ink_options.h"
#include "cli/options/options.h"
#include "cli/options/origin.h"
#include "cli/options/picture_field.h"
#include "cli/reports/output.h"
#include "cli/reports/report.h"
#include "cli/reports/writing.h"
#include "cli/terminal/interruption.h"
#include "cli/terminal/progress_bar.h"
#include "cli/terminal/stopwatch.h"
#include "drawing/dot_count.h"
#include "drawing/dot_size.h"
#include "drawing/pen/pen_path.h"
#include "drawing/picture.h"
#include "files/point_files.h"
#include "pictures/image.h"
#include "pictures/importance.h"

namespace lacuna::cli {
namespace {

constexpr const char* kStippleDescription =
    R"(Stipples a picture: random dots, evenly spread, dense where it is dark.

Examples:
  lacuna stipple photo.jpg -o dots.svg                       a number of dots that suits the picture
  lacuna stipple photo.jpg --count 20000 -o dots.svg         exactly 20000 dots
  lacuna stipple dim.jpg --auto-levels -o dots.svg -o dots.png   an underexposed photo, two files
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

With --dot-size 0.5mm all dots are equally large, as a pen draws them. Without --count there are as
many as give the picture's ink. A line warns of less than half of that ink or more than twice.

With --paper-size the picture lies in the middle of the paper, as large as --margin allows, and .svg
is in mm. Without it the page is the picture, and 512pt long.

Formats read are PNG, JPEG, PGM, PPM, PFM, Radiance HDR and NumPy's .npy. For photos that are too
dark or too light as a whole use --auto-levels.
)";

struct StippleCommand {
    CommonOptions common;
    Picture picture;
    DrawingOptions drawing;
    InkOptions inks;
    bool pen_path = false;
    std::optional<Mode> mode;
    std::uint32_t relax = RelaxOptions{}.iterations;
};

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
            [&options](const std::string& mode) { read_dot_mode(mode, options.mode); },
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

void add_pen_path(CLI::App& command, StippleCommand& options) {
    command
        .add_flag("--pen-path", options.pen_path,
                  "Orders the dots along a short path for a pen, in every format")
        ->disable_flag_override();
}

// Unless --mode is given: a set that keeps a least distance where an option is about distances,
// else the stratified one.
Mode mode_of(const StippleCommand& options) {
    if (options.mode) return *options.mode;
    if (!options.inks.inks.empty()) return Mode::stratified;
    const bool keeps_distance = options.relax == 0 || options.picture.has_metric ||
                                asks_for_distances(options.common.request);
    return keeps_distance ? Mode::cells : Mode::stratified;
}

// Checks everything that can be checked before the picture is read; returns the outputs.
std::vector<Output> check_options(const StippleCommand& options) {
    check_inks(options.inks, options.common.request, options.mode);
    check_start(mode_of(options), options.relax);
    const std::vector<Output> outputs =
        checked_outputs(options.common, {{"IMAGE", options.picture.path}});
    pictures::check(options.picture.importance);
    check_drawing(options.drawing, outputs);
    return outputs;
}

// What `lacuna stipple` has done besides sampling. Lengths are in the domain's units.
struct Work {
    double read_seconds = 0;
    double path_seconds = 0;
    double admitted_length = 0;  // of a pen's path through the dots in order of admission
    double path_length = 0;      // of the short path
    std::optional<Relaxation> relaxation;
};

// Orders the dots of each ink along a path of its own.
void order_for_a_pen(const StippleCommand& options, std::span<const files::Layer> layers,
                     Made& made, Work& work) {
    std::vector<Point>& points = made.result.points;
    ProgressBar bar(options.common.quiet);
    bar.note(fmt::format("a pen path through {} dots", points.size()));
    const Stopwatch stopwatch;
    std::vector<Point> ordered;
    ordered.reserve(points.size());
    const auto order = [&](std::span<const Point> dots) {
        const std::size_t first = ordered.size();
        for (const std::uint32_t index : pen::pen_path(dots, [] { return true; }))
            ordered.push_back(dots[index]);
        work.admitted_length += pen::path_length(dots);
        work.path_length += pen::path_length(std::span(ordered).subspan(first));
    };
    if (layers.empty()) order(points);
    for (const files::Layer& layer : layers)
        order(std::span(points).subspan(ordered.size(), layer.dots));
    work.path_seconds = stopwatch.seconds_so_far();
    points = std::move(ordered);
}

Json json_of(const DrawingOptions& options, const drawing::Style& style) {
    return {{"dot_size_mm", options.dot_size_mm ? Json(*options.dot_size_mm) : Json("radius")},
            {"paper_mm",
             style.sheet ? Json({style.sheet->width_mm, style.sheet->height_mm}) : Json(nullptr)},
            {"margin_mm", options.margin_mm},
            {"dpi", style.pixels_per_inch}};
}

Json json_of(const StippleCommand& options) {
    Json json{{"image", options.picture.path}};
    json.update(json_of_importance(options.picture.importance));
    json["relax"] = options.relax;
    if (!options.inks.inks.empty()) json.update(json_of(options.inks));
    json["pen_path"] = options.pen_path;
    return json;
}

Json report_of_the_rest(const StippleCommand& options, const std::vector<Output>& outputs,
                        const Field& field, const drawing::Style& style, const Work& work) {
    Json more{{"request", json_of(options)},
              {"image", {{"columns", field.columns}, {"rows", field.rows}}},
              {"seconds", {{"read", work.read_seconds}}}};
    if (has_picture(outputs)) more["request"].update(json_of(options.drawing, style));
    if (work.relaxation) more.update(json_of(*work.relaxation), true);
    if (!options.pen_path) return more;
    more["seconds"]["pen_path"] = work.path_seconds;
    more["pen_path"] = {{"length", work.path_length}, {"length_as_admitted", work.admitted_length}};
    return more;
}

// The length of the pen's path, for the summary at the end.
std::string path_text(const StippleCommand& options, const std::vector<Output>& outputs,
                      const files::PointSet& set, const drawing::Style& style, const Work& work) {
    if (!options.pen_path) return "";
    if (!has_picture(outputs))
        return fmt::format(", pen path {:.4g} longer sides", work.path_length);
    return fmt::format(", pen path {:.2f} m",
                       work.path_length * drawing::millimetres_per_unit(set, style) / 1000);
}

// The dots of all inks, ink by ink.
Made make_inks(const CommonOptions& common, const std::vector<Output>& outputs,
               std::uint32_t iterations, const Separation& separation, Work& work) {
    Made made;
    work.relaxation = place_inks(common, outputs, parts_of(separation),
                                 relax_options_of(common.request, iterations), made);
    return made;
}

void run(const CLI::App& command, const StippleCommand& options) {
    const std::vector<Output> outputs = check_options(options);
    Work work;
    const Stopwatch stopwatch;
    CommonOptions common = options.common;
    Request& request = common.request;
    request.mode = mode_of(options);
    if (request.mode == Mode::cells && options.relax != 0 && !options.picture.has_metric)
        request.metric = Metric::mean;
    const bool has_inks = !options.inks.inks.empty();
    Separation separation;
    if (has_inks) separation = read_separation(options.picture, options.inks, request);
    const Field field = has_inks ? std::move(separation.sum) : read_field(options.picture, request);
    request.field = &field;
    drawing::Style style = style_of(options.drawing, request.width, request.height);
    style.for_a_pen = options.pen_path;
    std::string note;
    if (!request.count && !request.scale && options.inks.counts.empty()) {
        request.count = drawing::default_count(field, request.width, request.height,
                                               options.drawing.dot_size_mm, style);
        note = " (chosen for the picture: --count gives another number)";
    }
    if (has_inks) {
        share_dots(separation, options.inks, request);
        note = fmt::format(" ({})", counts_text(separation));
    }
    work.read_seconds = stopwatch.seconds_so_far();

    Interruption interruption;
    Made made =
        has_inks ? make_inks(common, outputs, options.relax, separation, work) : make(common);
    if (options.relax != 0 && !has_inks)
        work.relaxation =
            relax_points(common, outputs, relax_options_of(request, options.relax), &field, made);
    if (options.pen_path) order_for_a_pen(options, separation.layers, made, work);
    if (!common.quiet) warn_of_ink(options.drawing, request, made.result.points.size(), style);

    const files::Origin origin = origin_of(command, request, made.result, json_of(options));
    files::PointSet set{made.result.points, request.width, request.height, made.result.radius,
                        &origin};
    set.layers = separation.layers;
    Writing writing(interruption);
    if (!common.report.empty())
        writing.add(common.report, [&] {
            return report_of(request, made,
                             report_of_the_rest(options, outputs, field, style, work));
        });
    write_set(writing, options.drawing, outputs, set, style, [&] {
        if (has_inks) return dot_diameters(separation, set);
        return drawing::dot_diameters(
            set.points, field, set.width, set.height,
            options.relax != 0 ? drawing::Spread::even : drawing::Spread::random);
    });
    sum_up(common, outputs, made, "dot", note, path_text(options, outputs, set, style, work));
}

}  // namespace

void add_stipple(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("stipple", kStippleDescription);
    const auto options = std::make_shared<StippleCommand>();
    add_what_to_stipple(command, *options);
    add_inks(command, options->inks);
    add_what_to_make(command, options->common.request);
    add_relax(command, options->relax);
    add_how_to_draw(command, options->drawing, "dots have as much ink as the picture is dark");
    add_pen_path(command, *options);
    add_effort(command, options->common.request);
    add_place(command, options->common.request);
    add_what_to_write(command, options->common);
    command.callback([&command, options] { run(command, *options); });
}

}  // namespace lacuna::cli
