// The options of `lacuna stipple`, and its run.
#include "cli/commands/commands.h"

#include <fmt/core.h>
#include <lacuna/stipple.h>
#include <unistd.h>

#include <CLI/Error.hpp>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/options/common_options.h"
#include "cli/options/domain_options.h"
#include "cli/options/drawing.h"
#include "cli/options/frames.h"
#include "cli/options/relaxation.h"
#include "cli/reports/output.h"
#include "cli/reports/report.h"
#include "cli/reports/stippled.h"
#include "cli/terminal/interruption.h"
#include "cli/terminal/run_program.h"
#include "drawing/picture.h"
#include "files/point_files.h"
#include "options/read.h"
#include "stipple/settled.h"

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
  lacuna stipple photo.jpg --along 4 -o hairs.svg            long dots along the edges
  lacuna stipple photo.jpg --along 6 --dot-size 0.4mm --paper-size A5 -o strokes.svg
                                                             strokes of a pen along the edges
  lacuna stipple photo.jpg --scale 0.003 -o dots.png         as many as there is room for
  lacuna stipple photo.jpg --count 20000 --relax 0 -o dots.pdf    grainy: the set of the article
  lacuna stipple photo.jpg --scale 0.003 --relax 0 --mode exact -o dots.npy   no gap is left
  lacuna stipple photo.jpg --dot-size 0.5mm --paper-size A6 --margin 8mm -o plot.svg
                                                             for a plotter with a pen of 0.5 mm
  lacuna stipple photo.jpg --pens 0.5mm,0.8mm,1.2mm --paper-size A5 --plot-time 1h -o plot.svg
                                                             three pens, and an hour's plot
  lacuna stipple photo.jpg --count 8000 --path-line -o line.svg    one line through all dots
  lacuna stipple density.npy --invert --count 5000 > points.txt       high numbers are dense

The domain is the picture, with a longer side of 1 and y upwards. Importance is 1 where the picture
is black and 0, which means no dots, where it is white; a grey of number v, 0 to 1, is covered to
1 - v. So the drawing, made smaller by any viewer, is the picture made smaller. Dots are placed at
random, so that every part of the picture has its share of them. Then they are moved, 15 times or as
--relax says: their cells then hold nearly equal darkness, and each dot is in the middle of its
cell.

With --relax 0 dots are not moved, and are at least a radius apart; the radius is
G / sqrt(importance), with the G of --scale. Dots come in the order in which they were admitted: the
first n, for any n, keep these distances, but have gaps. Where radii differ, --metric min (default)
keeps two dots at least the smaller radius apart, so that dots in light areas take no room from dark
areas. With mean and max dots in light areas take room from dark ones, and gaps remain along edges of
the picture.

With --mode cells dots are placed on a lattice, and about 4 % fewer fit than in the plane. With
--mode exact they are placed in the plane and no gap is left: the set of lacuna sample --field.
Either set may be relaxed, too; in mode cells --metric is then mean by default. Fine details then
have more dots than their share.

With --dot-size 0.5mm all dots are equally large, as a pen draws them, and with 0.3mm..0.8mm they
are larger where it is darker; --pens 0.3mm,0.5mm,0.8mm are the widths there are. Without a number
there are as many dots as cover the area that the picture's darkness asks for. A warning is printed
if --count, --scale or --plot-time give less than half of that area, or more than twice. Without
--dot-size and --pens, --size-by-tone makes dots in dark areas larger.

The dots of pens are ordered along a short path, unless --no-pen-path is given. With --plot-time 1h
there are as many dots as a plotter draws along it in at most an hour, and with pens no more than
the picture needs.

With --along 4 dots are ellipses, up to four times as long as wide, along the picture's edges. They
are made in --mode exact and are not relaxed. With --dot-size, too, they are strokes of a pen.

With --inks the picture's colours are separated. Of a colour that the inks cannot make, its
lightness is kept first, then its hue. The dots of each ink are evenly spread, and so are all dots
together. Files hold the dots of the first ink, then of the second.

With --paper-size the picture lies in the middle of the paper, as large as --margin allows, and .svg
is in mm. Without it the page is the picture, and its longer side is 512pt.

Formats read are PNG, JPEG, TIFF, WebP, HEIC, AVIF, PGM, PPM, PFM, Radiance HDR and NumPy's .npy.
For photos that are too dark or too light as a whole use --auto-levels.
)";

struct StippleCommand {
    CommonOptions common;  // its request is that of `stipple` once that is settled
    std::string image;     // path
    std::string frames;    // a pattern of paths, in place of it
    StippleOptions stipple;
    std::optional<double> pixels_per_inch;
    bool ellipse_columns = false;
};

// What the library is to do.
StippleOptions stipple_options(const StippleCommand& all) {
    StippleOptions options = all.stipple;
    options.measure = !all.common.report.empty();
    return options;
}

std::string names_of(const std::vector<Ink>& inks) {
    std::string names;
    for (const Ink& ink : inks) names += (names.empty() ? "" : ",") + ink.name;
    return names;
}

// Checks everything that can be checked before the picture is read; returns the outputs.
std::vector<Output> checked_outputs(const CommandLine& line, const StippleCommand& all,
                                    const StippleOptions& options) {
    check(options);
    if (all.common.output.paths.empty() && isatty(STDOUT_FILENO) == 1)
        throw BadUsage("nothing says where the dots are to be written: give -o FILE, one of " +
                       files::written_extensions() + ", or -o - for coordinates on the terminal");
    const std::vector<Output> outputs = checked_outputs(all.common, files_read(line));
    check_ellipse_columns(all.ellipse_columns, outputs);
    if (!options.inks.empty() && !loss_of_columns(outputs).empty())
        throw BadRequest("inks", names_of(options.inks),
                         "the ink of each dot " + loss_of_columns(outputs));
    return outputs;
}

// The pens of --dot-size or --pens, if no ink has one of its own.
std::optional<Pens> pens_of_all_inks(const StippleOptions& options) {
    for (const Ink& ink : options.inks)
        if (ink.pen_mm != 0) return std::nullopt;
    return options.pens;
}

Json json_of(const Ink& ink) {
    Json json{{"name", ink.name}, {"colour", files::hex_of(ink.colour)}};
    if (ink.pen_mm != 0) json["pen_mm"] = ink.pen_mm;
    return json;
}

// The options that decide the dots, for files and the report.
Json json_of(const StippleCommand& all, const StippleOptions& options, const Stippling& made) {
    Json json{{"image", all.image}};
    json.update(json_of_importance(options.tone));
    json["relax"] = made.iterations;
    if (!options.inks.empty()) {
        json["inks"] = Json::array();
        for (const Ink& ink : options.inks) json["inks"].push_back(json_of(ink));
        json["black_ink"] = options.black_ink.value_or(kBlackInk);
    }
    if (options.paper_colour != kWhitePaper)
        json["paper_colour"] = files::hex_of(options.paper_colour);
    if (!options.ink_counts.empty()) json["ink_counts"] = options.ink_counts;
    json["pen_path"] = made.is_for_a_pen;
    if (options.path_line) json["path_line"] = true;
    if (options.keep_inside) json["keep_inside"] = true;
    if (made.pen_mm != 0) json["pen_mm"] = made.pen_mm;
    if (made.circles) json["dot_style"] = "circle";
    if (options.size_by_tone != 0) json["size_by_tone"] = options.size_by_tone;
    return json;
}

// What the report has besides the set.
Json report_of_the_rest(const StippleCommand& all, const std::vector<Output>& outputs,
                        const Stippling& made, double resolution, Json options) {
    if (has_picture(outputs))
        options.update(
            {{"dot_size_mm", json_of_pens(all.stipple.pens)},
             {"paper_mm",
              made.paper ? Json({made.paper->width_mm, made.paper->height_mm}) : Json(nullptr)},
             {"margin_mm", made.paper ? all.stipple.paper->margin_mm : 0},
             {"dpi", resolution}});
    Json more{{"request", std::move(options)},
              {"image", {{"columns", made.columns}, {"rows", made.rows}}}};
    if (made.relaxed) {
        Relaxation relaxation{{.iterations = made.iterations}, *made.relaxed, std::nullopt};
        if (made.result.points.size() > 1) relaxation.least_distance = made.result.radius;
        more.update(json_of(relaxation), true);
    }
    if (made.is_for_a_pen)
        more["pen_path"] = {{"length", made.path_length},
                            {"length_as_admitted", made.admitted_length}};
    if (made.plot_seconds != 0) more["plot_seconds"] = made.plot_seconds;
    for (std::size_t k = 0; k < made.layers.size() && made.plot_seconds != 0; ++k)
        more["layers"].push_back({{"name", made.layers[k].ink.name},
                                  {"dots", made.layers[k].dots},
                                  {"path_length", made.layer_plots[k].path_length},
                                  {"plot_seconds", made.layer_plots[k].seconds}});
    return more;
}

// Makes the dots of one picture, and its files. Returns the dots.
std::vector<Point> run_one(const CommandLine& line, const StippleCommand& all) {
    const StippleOptions options = stipple_options(all);
    const std::vector<Output> outputs = checked_outputs(line, all, options);
    const DrawingOptions drawing = checked_drawing(
        line, {pens_of_all_inks(options), options.paper, all.pixels_per_inch}, outputs);
    CommonOptions common = all.common;
    common.request = options.request;
    Interruption interruption;
    Finished made{.stopwatch = Stopwatch(!common.report.empty())};
    const lacuna::Picture picture = read_picture(all.image);
    const Stippling dots = watched(
        common, made, [&](Observer& observer) { return stipple(picture, options, observer); });
    made.result = dots.result;
    const Request& request = common.request = dots.request;
    if (!common.quiet && options.start_points.empty()) {
        warn_of_darkness(line, all.image, dots);
        warn_of_ink(drawing, {.dots = made.result.points.size(),
                              .suits = dots.dots_for_ink,
                              .domain = request.domain,
                              .widest_pen_mm = stippling::widest_pen(options),
                              .are_line = options.path_line,
                              .has_gamma = line.has("gamma")});
    }

    Json asked = json_of(all, options, dots);
    asked["image_sha256"] = files::sha256_of_bytes(picture.content);
    files::Origin origin = origin_of(line, request, made.result, asked);
    origin.image_sha256 = asked["image_sha256"];
    auto shown = drawing::shown(dots);
    if (!common.quiet) warn_of_widths(shown, dots, outputs);
    files::PointSet& set = shown.set;
    drawing::Style& style = shown.style;
    style.pixels_per_inch = all.pixels_per_inch;
    set.origin = &origin;
    set.writes_ellipses = all.ellipse_columns;
    const auto report = [&] {
        return report_of(
            request, made,
            report_of_the_rest(all, outputs, dots, drawing::resolution_of(set, style), asked));
    };
    finish(interruption, common, drawing, outputs,
           {.set = set,
            .style = style,
            .find_diameters = [&] { return dots.diameters; },
            .report = report,
            .words = words_of(common, made, "dot", note_on_count(options, dots),
                              plot_text(options, set, style, dots))});
    return dots.result.points;
}

// The picture, or those of a sequence: each begins with the dots of the one before.
void run(const CommandLine& line, const StippleCommand& all) {
    if (all.frames.empty()) {
        if (all.image.empty()) throw CLI::RequiredError("IMAGE");
        refuse_frame_in(all.common.output.paths);
        run_one(line, all);
        return;
    }
    const std::vector<Frame> frames = frames_of(all.frames, all.common.output.paths);
    if (all.stipple.relax == 0U)
        throw BadRequest("frames", "with --relax 0", "dots are moved on from picture to picture");
    const auto command_of = [&](const Frame& frame) {
        StippleCommand one = all;
        one.image = frame.image;
        one.common.output.paths = frame.outputs;
        return one;
    };
    for (const Frame& frame : frames) checked_outputs(line, command_of(frame), all.stipple);
    std::vector<Point> dots;
    for (const Frame& frame : frames) {
        StippleCommand one = command_of(frame);
        if (!dots.empty()) {
            one.stipple.request.count = dots.size();
            if (one.stipple.plot_seconds) one.stipple.pen_path = true;
            one.stipple.plot_seconds.reset();
            one.stipple.start_points = std::move(dots);
        }
        dots = run_one(line, one);
        Interruption::note_files();
    }
}

// Where the value of each option goes.
Targets targets_of(StippleCommand& all) {
    Targets targets{{"IMAGE", &all.image},
                    {"frames", &all.frames},
                    {"ellipse-columns", &all.ellipse_columns},
                    {"dpi", &all.pixels_per_inch},
                    {"report", &all.common.report},
                    {"quiet", &all.common.quiet}};
    targets.merge(options::targets_of(all.stipple));
    targets.merge(targets_of(all.common.output));
    return targets;
}

}  // namespace

void add_stipple(CLI::App& app) {
    const auto all = std::make_shared<StippleCommand>();
    add_command(app, options::kStipple, kStippleDescription, targets_of(*all),
                [all](const CommandLine& line) { run(line, *all); });
}

}  // namespace lacuna::cli
