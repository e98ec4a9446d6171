// lacuna::stipple: the number of dots, the dots themselves, their sizes and their order.
#include <lacuna/stipple.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <span>
#include <string>
#include <utility>

#include "base/asked.h"
#include "base/number_text.h"
#include "drawing/dot_count.h"
#include "drawing/page.h"
#include "drawing/pen/pen_path.h"
#include "drawing/tones.h"
#include "files/point_files.h"
#include "pictures/importance.h"
#include "plan/checked_request.h"
#include "recipes/make.h"
#include "recipes/settle.h"
#include "recipes/targets.h"

namespace lacuna {
namespace {

bool has_ellipses(const StippleOptions& options) {
    return options.tone.along != 1;
}

std::uint64_t sum_of(std::span<const std::uint64_t> counts) {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

// What was given, as a command line.
recipes::CommandLine line_of(StippleOptions options) {
    StippleOptions usual;
    recipes::CommandLine line{recipes::kStipple,
                              recipes::given_in(recipes::kStipple, recipes::targets_of(options),
                                                recipes::targets_of(usual))};
    if (!options.inks.empty()) line.given.push_back({"inks", {options.inks.front().name}});
    if (!options.ink_counts.empty())
        line.given.push_back({"ink-counts", {std::to_string(options.ink_counts.front())}});
    if (options.paper_colour != kWhitePaper)
        line.given.push_back({"paper-colour", {files::hex_of(options.paper_colour)}});
    if (options.plot_seconds)
        line.given.push_back({"plot-time", {shortest(*options.plot_seconds) + "s"}});
    return line;
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
    if (options.inks.empty() && is_dark(options.paper_colour))
        throw BadRequest("paper-colour", paper,
                         "is too dark for black dots: give --inks, such as white");
    const auto& counts = options.ink_counts;
    if (counts.empty()) return;
    if (counts.size() != options.inks.size())
        throw BadRequest("ink-counts", fmt::format("{} numbers", counts.size()),
                         fmt::format("must be one for each ink, {}", options.inks.size()));
    if (sum_of(counts) == 0) throw BadRequest("ink-counts", "0", "must not be 0 for all inks");
}

void check_pens(const StippleOptions& options) {
    const auto refuse_unless = [](bool is_allowed, const char* option, double mm) {
        if (!is_allowed)
            throw BadRequest(option, shortest(mm) + "mm",
                             "must be widths over 0, in ascending order");
    };
    for (const Ink& ink : options.inks)
        refuse_unless(ink.pen_mm >= 0 && std::isfinite(ink.pen_mm), "inks", ink.pen_mm);
    if (!options.pens) return;
    const auto& [least, most, widths] = *options.pens;
    refuse_unless(least > 0, "pens", least);
    refuse_unless(least <= most && std::isfinite(most), "pens", most);
    for (std::size_t i = 0; i < widths.size(); ++i)
        refuse_unless(widths[i] >= (i == 0 ? least : widths[i - 1]) && widths[i] <= most, "pens",
                      widths[i]);
}

void check_plotter(const StippleOptions& options) {
    const auto check = [](const char* name, double seconds) {
        if (!(seconds >= 0 && std::isfinite(seconds)))
            throw BadRequest(name, shortest(seconds), "must be a finite number of at least 0");
    };
    check("seconds-per-dot", options.plotter.seconds_per_dot);
    check("seconds-per-metre", options.plotter.seconds_per_metre);
    if (!options.plot_seconds) return;
    check("plot-time", *options.plot_seconds);
    if (options.plotter.seconds_per_dot == 0 && options.plotter.seconds_per_metre == 0)
        throw BadRequest("plot-time", shortest(*options.plot_seconds),
                         "needs a plotter that takes more than 0 seconds");
}

// A stippling without dots: its request has the mode and the metric.
Stippling settled(const StippleOptions& options) {
    pictures::check(options.tone);
    recipes::refuse_pairs(line_of(options));
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
    check_plotter(options);
    const recipes::Given given{.is_picture = true,
                               .has_inks = !options.inks.empty(),
                               .has_ellipses = has_ellipses(options),
                               .mode = options.start,
                               .metric = options.metric,
                               .relax = options.relax};
    Stippling made{.request = options.request};
    made.iterations = recipes::relax_of(given);
    made.paper_colour = options.paper_colour;
    made.is_for_a_pen = options.pen_path || options.path_line || options.plot_seconds;
    recipes::settle(given, made.request);
    recipes::check_moves(made.request, {.iterations = made.iterations});
    return made;
}

// Makes the dots of a picture's tones, step by step.
class Stippler {
public:
    Stippler(Stippling& made, drawing::Tones& tones, const StippleOptions& options,
             Observer& observer)
        : made_(made), tones_(tones), options_(options), observer_(observer) {
        const Field& all = tones.all();
        request().domain = domain_like(all.columns, all.rows, request().domain.boundary);
        request().field = tones.has_inks() ? &tones.sum : &tones.densities().front();
        made.columns = all.columns;
        made.rows = all.rows;
        if (options.paper) made.paper = drawing::turned(*options.paper, request().domain);
        style_.sheet = made.paper;
    }

    void run() {
        choose_count();
        place();
        if (options_.keep_inside) drawing::pull_inside(tones_, dots(), style_, made_.result.points);
        if (options_.keep_inside) recipes::note_moves(request(), made_.result);
        layers_ = tones_.layers;
        if (auto pens = drawing::layers_of_pens(tones_, request().domain, made_.result.points);
            !pens.empty())
            layers_ = std::move(pens);
        if (made_.is_for_a_pen) order_for_a_pen();
        if (made_.is_for_a_pen || tones_.has_pens()) time_the_plot();
        find_sizes();
        if (!request().field->stretches.empty())
            made_.ellipses = ellipses_of(made_.result.points, *request().field, made_.result.scale,
                                         request().domain);
        made_.layers = std::move(layers_);
        request().field = nullptr;
    }

private:
    Request& request() { return made_.request; }

    files::PointSet dots() {
        files::PointSet set{made_.result.points, request().domain};
        set.layers = layers_;
        return set;
    }

    // Sets the number of dots, in all and of each ink.
    void choose_count() {
        const auto& counts = options_.ink_counts;
        if (!counts.empty())
            request().count = sum_of(counts);
        else if (options_.plot_seconds)
            request().count = drawing::plotted_count(tones_, request().domain, style_, plotter(),
                                                     *options_.plot_seconds);
        else if (options_.path_line && options_.pens && !request().count)
            request().count =
                drawing::count_of_line(tones_, request().domain, style_, options_.pens->least_mm);
        else if (!request().count && !request().scale)
            request().count = drawing::suiting_count(tones_, request().domain, style_);
        if (!tones_.has_inks()) return;
        check_request(request());
        if (counts.empty()) return drawing::share_dots(tones_, *request().count);
        for (std::size_t k = 0; k < counts.size(); ++k) {
            tones_.layers[k].dots = counts[k];
            if (counts[k] != 0 && pictures::is_zero_all_over(tones_.fields[k].importance))
                throw BadRequest("ink-counts", std::to_string(counts[k]),
                                 fmt::format("must be 0 for {}: the picture needs none of this ink",
                                             options_.inks[k].name));
        }
    }

    // Places the dots and moves them.
    void place() {
        const recipes::Moves moves{.iterations = made_.iterations, .measure = options_.measure};
        recipes::Made placed =
            tones_.has_inks()
                ? recipes::make_in_inks(request(), drawing::parts_of(tones_), moves, observer_)
                : recipes::make(request(), moves, observer_);
        made_.result = std::move(placed.result);
        made_.relaxed = std::move(placed.relaxed);
    }

    // Orders the dots of each ink, or all dots if there is none, along a path of their own.
    void order_for_a_pen() {
        const std::uint64_t count = made_.result.points.size();
        const auto may_go_on = [&] {
            return observer_.keep_going({count, count, 0, Stage::pen_path});
        };
        if (!may_go_on()) throw Cancelled();
        observer_.begin(Verb::pen_path);
        std::vector<Point> ordered;
        ordered.reserve(count);
        drawing::for_each_layer(dots(), {}, [&](std::size_t, const auto& part, const auto&) {
            for (const std::uint32_t index : pen::pen_path(part.points, may_go_on))
                ordered.push_back(part.points[index]);
            made_.admitted_length += pen::path_length(part.points);
        });
        made_.result.points = std::move(ordered);
        observer_.end(Verb::pen_path);
    }

    // The pen stays down on a line.
    Plotter plotter() const {
        Plotter plotter = options_.plotter;
        if (options_.path_line) plotter.seconds_per_dot = 0;
        return plotter;
    }

    void time_the_plot() {
        drawing::for_each_layer(dots(), {}, [&](std::size_t, const auto& part, const auto&) {
            made_.path_length += pen::path_length(part.points);
        });
        if (!made_.is_for_a_pen) made_.admitted_length = made_.path_length;
        made_.plot_seconds =
            drawing::seconds_of(plotter(), made_.result.points.size(),
                                made_.path_length * drawing::millimetres_per_unit(dots(), style_));
    }

    void find_sizes() {
        if (options_.path_line) return find_width();
        made_.dots_for_ink = drawing::dots_for_ink(tones_, request().domain, style_);
        made_.diameters = drawing::diameters_of(tones_, dots(), style_);
    }

    // The width at which the line has as much ink as the picture is dark, or that of the pen.
    void find_width() {
        const Domain& domain = request().domain;
        const double ink = drawing::darkness_of(tones_.all()) * domain.width * domain.height;
        made_.line_width =
            options_.pens ? options_.pens->least_mm / drawing::millimetres_per_unit(dots(), style_)
                          : ink / std::max(made_.path_length, ink);
    }

    Stippling& made_;
    drawing::Tones& tones_;
    const StippleOptions& options_;
    Observer& observer_;
    drawing::Style style_;
    std::vector<Layer> layers_;  // the inks or, if each has several pens, those
};

}  // namespace

void check(const StippleOptions& options) {
    settled(options);
}

Stippling stipple(std::vector<Field> importance, const StippleOptions& options,
                  Observer& observer) {
    Stippling made = settled(options);
    Asked asked(observer, {0, options.request.count.value_or(1), 0});
    drawing::Tones tones{
        .sizing = {.by_tone = options.size_by_tone,
                   .pens = options.pens,
                   .is_line = options.path_line},
        .keep_inside = options.keep_inside,
        .spread = made.iterations != 0 ? drawing::Spread::even : drawing::Spread::random};
    drawing::set_fields(tones, std::move(importance), options.inks);
    Stippler(made, tones, options, asked).run();
    return made;
}

}  // namespace lacuna
