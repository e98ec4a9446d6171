// What stipple() refuses whatever the picture is, and what follows from options.
#include "stipple/settled.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>

#include "base/number_text.h"
#include "checks/numbers.h"
#include "drawing/picture.h"
#include "files/point_files.h"
#include "options/make.h"
#include "options/settle.h"
#include "options/targets.h"
#include "pictures/importance.h"

namespace lacuna {
namespace {

bool has_ellipses(const StippleOptions& options) {
    return options.tone.along != 1;
}

// What is set, by the names of options.
std::vector<options::GivenOption> members_set(StippleOptions options) {
    StippleOptions usual;
    std::vector<options::GivenOption> given = options::given_in(
        options::kStipple, options::targets_of(options), options::targets_of(usual));
    if (!options.inks.empty()) given.push_back({"inks", {options.inks.front().name}});
    if (!options.ink_counts.empty())
        given.push_back({"ink-counts", {std::to_string(options.ink_counts.front())}});
    if (options.pen_path == false) given.push_back({"no-pen-path"});
    if (options.pens)
        given.push_back({options.pens->widths_mm.empty() ? "dot-size" : "pens",
                         {shortest(options.pens->least_mm) + "mm"}});
    if (options.pen_mm) given.push_back({"pen", {shortest(*options.pen_mm) + "mm"}});
    if (options.circles) given.push_back({"dot-style", {"circle"}});
    if (!options.start_points.empty())
        given.push_back({"start-points", {fmt::format("{} dots", options.start_points.size())}});
    if (options.plot_seconds)
        given.push_back({"plot-time", {shortest(*options.plot_seconds) + "s"}});
    return given;
}

// Whether dark dots show on the paper: the brightness of its colour.
bool is_dark(const Colour& paper) {
    constexpr int kDark = 96;
    return std::max({paper[0], paper[1], paper[2]}) < kDark;
}

void check_inks(const StippleOptions& options) {
    const std::string paper = files::hex_of(options.paper_colour);
    for (const Ink& ink : options.inks)
        if (ink.colour == options.paper_colour)
            throw BadRequest("inks", ink.name,
                             "is the colour of the paper, " + paper +
                                 ", where it would not show: see --paper-colour");
    if (options.black_ink && options.paper_colour != kWhitePaper)
        throw BadRequest("black-ink", shortest(*options.black_ink),
                         "is for white paper, not for " + paper);
    if (options.inks.empty() && is_dark(options.paper_colour))
        throw BadRequest("paper-colour", paper,
                         "is too dark for black dots: give --inks, such as white");
    const auto& counts = options.ink_counts;
    if (counts.empty()) return;
    if (counts.size() != options.inks.size())
        throw BadRequest("ink-counts", fmt::format("{} numbers", counts.size()),
                         fmt::format("must be one for each ink, {}", options.inks.size()));
    if (std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}) == 0)
        throw BadRequest("ink-counts", "0", "must not be 0 for all inks");
}

void check_room(const StippleOptions& options) {
    if (!options.paper) return;
    const auto& [width, height, margin, may_turn] = *options.paper;
    const double pen = stippling::widest_pen(options);
    if (2 * margin + pen >= std::min(width, height))
        throw BadRequest("margin", shortest(margin) + "mm",
                         "leaves no room on the paper for a pen of " + shortest(pen) + "mm");
}

void check_pens(const StippleOptions& options) {
    const auto refuse_unless = [](bool is_allowed, const char* option, double mm) {
        if (!is_allowed)
            throw BadRequest(option, shortest(mm) + "mm",
                             "must be widths over 0, in ascending order");
    };
    for (const Ink& ink : options.inks)
        refuse_unless(ink.pen_mm >= 0 && std::isfinite(ink.pen_mm), "inks", ink.pen_mm);
    const auto has_pen = [](const Ink& ink) { return ink.pen_mm != 0; };
    const auto with_pen = std::count_if(options.inks.begin(), options.inks.end(), has_pen);
    const auto without = std::find_if_not(options.inks.begin(), options.inks.end(), has_pen);
    if (with_pen != 0 && without != options.inks.end() && !options.pens)
        throw BadRequest("inks", without->name,
                         "needs a pen, as others have: give it one, such as " + without->name +
                             ":0.5mm, or --dot-size");
    if (options.size_by_tone != 0 && with_pen != 0)
        throw BadRequest("size-by-tone", shortest(options.size_by_tone), "is not for pens");
    if (!options.pens) return;
    const auto& [least, most, widths] = *options.pens;
    if (has_ellipses(options) && least != most)
        throw BadRequest("dot-size", shortest(least) + "mm.." + shortest(most) + "mm",
                         "must be one pen with --along, whose dots are strokes");
    refuse_unless(least > 0, "pens", least);
    refuse_unless(least <= most && std::isfinite(most), "pens", most);
    if (options.path_line && least != most)
        throw BadRequest("path-line", "with " + shortest(least) + "mm.." + shortest(most) + "mm",
                         "must have one pen, or one for each ink");
    if (has_ellipses(options) && options.keep_inside)
        throw BadRequest("keep-inside", "with --along",
                         "is for dots: with a pen there are strokes");
    constexpr std::size_t kMostLayers = 254;  // of a file
    if (std::max<std::size_t>(1, options.inks.size()) * widths.size() > kMostLayers)
        throw BadRequest("pens", fmt::format("{} widths", widths.size()),
                         fmt::format("must be at most {} layers of inks and pens", kMostLayers));
    for (std::size_t i = 0; i < widths.size(); ++i)
        refuse_unless(widths[i] >= (i == 0 ? least : widths[i - 1]) && widths[i] <= most, "pens",
                      widths[i]);
}

void check_one_pen(const StippleOptions& options) {
    if (!options.pen_mm) return;
    const double pen = *options.pen_mm;
    if (!(pen > 0) || !std::isfinite(pen))
        throw BadRequest("pen", shortest(pen) + "mm", "must be a width over 0");
    for (const Ink& ink : options.inks)
        if (ink.pen_mm != 0)
            throw BadRequest("pen", shortest(pen) + "mm",
                             "is not for --inks with pens of their own");
    if (options.pens && options.pens->least_mm < pen)
        throw BadRequest("dot-size", shortest(options.pens->least_mm) + "mm",
                         "must be at least the pen's " + shortest(pen) + "mm");
}

void check_plotter(const StippleOptions& options) {
    const auto& [per_dot, per_metre_down, per_metre_up, per_corner] = options.plotter;
    check_at_least_0("seconds-per-dot", per_dot);
    check_at_least_0("seconds-per-metre-down", per_metre_down);
    check_at_least_0("seconds-per-metre-up", per_metre_up);
    check_at_least_0("seconds-per-corner", per_corner);
    if (!options.plot_seconds) return;
    check_at_least_0("plot-time", *options.plot_seconds);
    if (per_dot == 0 && per_metre_down == 0 && per_metre_up == 0)
        throw BadRequest("plot-time", shortest(*options.plot_seconds),
                         "needs a plotter that takes more than 0 seconds");
}

}  // namespace

double stippling::widest_pen(const StippleOptions& options) {
    double widest = options.pens ? options.pens->most_mm : 0;
    for (const Ink& ink : options.inks) widest = std::max(widest, ink.pen_mm);
    return widest;
}

Stippling stippling::settled(const StippleOptions& options) {
    pictures::check(options.tone);
    options::refuse_pairs(options::kStipple, members_set(options));
    if (options.start == Mode::lines)
        throw BadRequest("mode", "lines", "must be stratified, cells or exact");
    check_inks(options);
    if (!(options.size_by_tone >= 0 && options.size_by_tone <= 1))
        throw BadRequest("size-by-tone", shortest(options.size_by_tone), "must be 0 to 1");
    if (options.size_by_tone != 0 && options.pens)
        throw BadRequest("size-by-tone", shortest(options.size_by_tone),
                         "is not for a --dot-size in mm; give two, such as 0.3mm..0.8mm");
    if (options.paper) drawing::check(*options.paper);
    check_pens(options);
    check_one_pen(options);
    check_room(options);
    check_plotter(options);
    const options::Choices given{.is_picture = true,
                                 .has_inks = !options.inks.empty(),
                                 .has_ellipses = has_ellipses(options),
                                 .mode = options.start,
                                 .metric = options.metric,
                                 .relax = options.relax};
    Stippling made{.request = options.request};
    made.iterations = options::relax_of(given);
    if (!options.start_points.empty() && made.iterations == 0)
        throw BadRequest("start-points", "with --relax 0", "they are moved on");
    if (!options.start_points.empty() &&
        options.request.count.value_or(options.start_points.size()) != options.start_points.size())
        throw BadRequest("count", std::to_string(*options.request.count),
                         fmt::format("must be the number of dots to start with, {}",
                                     options.start_points.size()));
    made.paper_colour = options.paper_colour;
    made.pen_mm = options.pen_mm.value_or(0);
    made.circles = options.circles;
    made.is_for_a_pen =
        options.pen_path.value_or(stippling::widest_pen(options) != 0 || options.pen_mm) ||
        options.path_line || options.plot_seconds;
    options::settle(given, made.request);
    options::check_moves(made.request, {.iterations = made.iterations});
    return made;
}

void check(const StippleOptions& options) {
    stippling::settled(options);
}

}  // namespace lacuna
