// lacuna::stipple: the number of dots, the dots themselves, their sizes and their order.
#include <lacuna/stipple.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <string>
#include <utility>

#include "base/asked.h"
#include "base/number_text.h"
#include "drawing/page.h"
#include "files/point_files.h"
#include "options/make.h"
#include "pictures/importance.h"
#include "plan/checked_request.h"
#include "stipple/dot_count.h"
#include "stipple/fit_strokes.h"
#include "stipple/pen/pen_path.h"
#include "stipple/place_dots.h"
#include "stipple/plot.h"
#include "stipple/settled.h"
#include "stipple/strokes.h"
#include "stipple/tones.h"

namespace lacuna {
namespace {

std::uint64_t sum_of(std::span<const std::uint64_t> counts) {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

// Makes the dots of a picture's tones, step by step.
class Stippler {
    // A maximal set has this many points in a square of its radius.
    static constexpr double kCoverage = 0.697;
    // The scale R of strokes, in pens' widths, where the picture is black: strokes 1.6 R long then
    // have the ink.
    static constexpr double kStrokesApart = 1.6 * kCoverage;

public:
    Stippler(Stippling& made, stippling::Tones& tones, const StippleOptions& options,
             Observer& observer)
        : made_(made), tones_(tones), options_(options), observer_(observer) {
        const Field& all = tones.all();
        request().domain = domain_like(all.columns, all.rows, request().domain.boundary);
        request().field = tones.has_inks() ? &tones.sum : &tones.densities().front();
        made.columns = all.columns;
        made.rows = all.rows;
        made.darkness = stippling::darkness_of(all);
        if (options.paper) {
            style_.sheet = drawing::turned(*options.paper, request().domain);
            style_.sheet->margin_mm += stippling::widest_pen(options) / 2;
        }
        find_scale();
    }

    void run() {
        choose_count();
        make();
        // They may take longer than expected: strokes that cross are longer, and ways are longer
        // between long strokes and from pen to pen.
        constexpr int kTrials = 4;
        for (int trial = 0; trial < kTrials && take_too_long(); ++trial) {
            request().count = count_in_time();
            request().scale.reset();
            if (tones_.has_inks()) stippling::share_dots(tones_, *request().count);
            make();
        }
        made_.layers = std::move(layers_);
        request().field = nullptr;
    }

private:
    // Whether the plot takes longer than asked for, and could have fewer dots or strokes.
    bool take_too_long() const {
        return options_.plot_seconds && options_.start_points.empty() &&
               made_.plot_seconds > *options_.plot_seconds;
    }

    // Ways, lines and strokes grow with the root of the number; each dot takes the same time.
    std::uint64_t count_in_time() const {
        const auto count = static_cast<double>(made_.result.points.size());
        const double seconds = 0.995 * *options_.plot_seconds;
        const bool has_dots = !made_.are_strokes && !options_.path_line;
        const double of_dot = has_dots ? options_.plotter.seconds_per_dot : 0;
        const double of_ways = (made_.plot_seconds - of_dot * count) / std::sqrt(count);
        const double root =
            2 * seconds / (of_ways + std::sqrt(of_ways * of_ways + 4 * of_dot * seconds));
        return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(root * root));
    }

    void make() {
        made_.admitted_length = 0;
        place();
        if (options_.keep_inside) {
            stippling::pull_inside(tones_, dots(), style_, made_.result.points);
            options::note_moves(request(), made_.result);
        }
        layers_ = tones_.layers;
        if (auto pens = stippling::layers_of_pens(tones_, request().domain, made_.result.points);
            !pens.empty())
            layers_ = std::move(pens);
        if (made_.is_for_a_pen) order_for_a_pen();
        if (!request().field->stretches.empty())
            made_.ellipses = ellipses_of(made_.result.points, *request().field, made_.result.scale,
                                         request().domain);
        if (made_.are_strokes) turn_into_strokes();
        const bool has_pen = made_.is_for_a_pen || tones_.has_pens();
        find_sizes();
        make_room();
        if (has_pen) stippling::plot(made_, dots(), options_.plotter, mm_);
    }

    Request& request() { return made_.request; }

    files::PointSet dots() {
        files::PointSet set{made_.result.points, request().domain};
        set.layers = layers_;
        return set;
    }

    void find_scale() {
        mm_ = drawing::millimetres_per_unit(files::PointSet{{}, request().domain}, style_);
    }

    // Sets the number of dots, in all and of each ink.
    void choose_count() {
        const auto& counts = options_.ink_counts;
        if (!options_.start_points.empty())
            request().count = options_.start_points.size();
        else if (!counts.empty())
            request().count = sum_of(counts);
        else if (options_.plot_seconds)
            choose_for_time();
        else if (made_.are_strokes && !request().count && !request().scale)
            request().scale = kStrokesApart * pen();
        else if (options_.path_line && tones_.has_pens() && !request().count)
            request().count = stippling::count_of_line(tones_, request().domain, style_);
        else if (!request().count && !request().scale)
            request().count = stippling::suiting_count(tones_, request().domain, style_);
        if (!tones_.has_inks()) return suit_narrow_shapes();
        check_request(request());
        if (counts.empty()) {
            stippling::share_dots(tones_, *request().count);
            suit_narrow_shapes();
            return stippling::share_dots(tones_, *request().count);
        }
        for (std::size_t k = 0; k < counts.size(); ++k) {
            tones_.layers[k].dots = counts[k];
            if (counts[k] != 0 && pictures::is_zero_all_over(tones_.fields[k].importance))
                throw BadRequest("ink-counts", std::to_string(counts[k]),
                                 fmt::format("must be 0 for {}: the picture needs none of this ink",
                                             options_.inks[k].name));
        }
        suit_narrow_shapes();
    }

    // The style with the pen of all dots.
    drawing::Style pen_style() const {
        drawing::Style style = style_;
        style.pen_mm = made_.pen_mm;
        style.circles = made_.circles;
        return style;
    }

    // As many dots as the time is enough for or, if that is less, as the picture needs.
    void choose_for_time() {
        const std::uint64_t dots = stippling::plotted_count(
            tones_, request().domain, pen_style(), options_.plotter, *options_.plot_seconds);
        auto needed = static_cast<std::uint64_t>(stippling::kMostDots);
        if (made_.are_strokes) {
            needed = natural_strokes();
        } else if (tones_.has_pens()) {
            needed = options_.path_line
                         ? stippling::count_of_line(tones_, request().domain, style_)
                         : stippling::suiting_count(tones_, request().domain, style_);
        }
        made_.is_finished_sooner = dots >= needed;
        if (made_.is_finished_sooner && made_.are_strokes)
            request().scale = kStrokesApart * pen();
        else
            request().count = std::min(dots, needed);
    }

    // About how many strokes there are of the scale at which light ones just leave each other room.
    std::uint64_t natural_strokes() {
        const double apart = kStrokesApart * pen();
        const Domain& domain = request().domain;
        return static_cast<std::uint64_t>(kCoverage *
                                          stippling::darkness_of(tones_.densities().front()) *
                                          domain.width * domain.height / (apart * apart));
    }

    void suit_narrow_shapes() {
        if (!request().count) return;
        stippling::suit_narrow_shapes(tones_, request().domain, *request().count);
        if (!tones_.has_inks()) request().field = &tones_.densities().front();
    }

    // Places the dots and moves them.
    void place() {
        const options::Moves moves{.iterations = made_.iterations, .measure = options_.measure};
        const std::vector<Point>& start = options_.start_points;
        for (const Point& point : start)
            if (!request().domain.holds(point))
                throw BadRequest("start-points",
                                 fmt::format("({}, {})", shortest(point.x), shortest(point.y)),
                                 "must lie in the picture: is it one of other proportions?");
        // Dots that are kept inside do not overhang the picture's edges either.
        const auto edges = options_.keep_inside ? stippling::Edges::closed : stippling::Edges::open;
        options::Made placed = stippling::place_dots(request(), stippling::parts_of(tones_), start,
                                                     moves, edges, observer_);
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

    void find_sizes() {
        if (options_.path_line) return find_width();
        if (!made_.are_strokes)
            made_.dots_for_ink = stippling::dots_for_ink(tones_, request().domain, style_);
        made_.diameters = stippling::diameters_of(tones_, dots(), style_);
        for (double& one : made_.diameters) one = std::max(one, made_.pen_mm / mm_);
    }

    // Lets no ink lie in the margin. The constructor has made room for pens.
    void make_room() {
        if (style_.sheet && stippling::widest_pen(options_) == 0) {
            drawing::Style style = style_;
            style.diameters = made_.diameters;
            style.line_width = made_.line_width;
            files::PointSet set = dots();
            set.ellipses = made_.ellipses;
            style_.sheet = drawing::with_room_for_ink(set, style);
            find_scale();
        }
        made_.paper = style_.sheet;
    }

    // The area of all ink, on itself or on paper.
    double ink() { return stippling::ink_of(tones_, request().domain); }

    // The width of the pen, in the domain's unit.
    double pen() const { return options_.pens->least_mm / mm_; }

    void turn_into_strokes() {
        std::vector<Point>& middles = made_.result.points;
        std::vector<double> reaches;
        for (const Ellipse& one : made_.ellipses) reaches.push_back(std::sqrt(one.a * one.b));
        stippling::make_strokes(made_.ellipses, ink(), pen());
        stippling::fit_strokes(middles, made_.ellipses, reaches, tones_.all(), request().domain);
        if (stippling::cut_strokes(middles, made_.ellipses, request().domain))
            options::note_moves(request(), made_.result);
        stippling::turn_strokes(middles, made_.ellipses);
    }

    // The width at which the line has as much ink as the picture is dark, or that of the pen.
    void find_width() {
        const double area = ink();
        stippling::plot(made_, dots(), options_.plotter, mm_);
        // An ink with a pen of its own has its width.
        made_.line_width = options_.pens ? pen() : area / std::max(made_.path_length, area);
        if (tones_.has_pens())
            made_.dots_for_ink =
                static_cast<double>(stippling::count_of_line(tones_, request().domain, style_));
    }

    Stippling& made_;
    stippling::Tones& tones_;
    const StippleOptions& options_;
    Observer& observer_;
    drawing::Style style_;
    double mm_ = 0;              // a unit of the domain on the page
    std::vector<Layer> layers_;  // the inks or, if each has several pens, those
};

}  // namespace

Stippling stipple(std::vector<Field> importance, const StippleOptions& options,
                  Observer& observer) {
    Stippling made = stippling::settled(options);
    made.are_strokes = options.pens && !importance.empty() && !importance.front().stretches.empty();
    Asked asked(observer, {0, options.request.count.value_or(1), 0});
    stippling::Tones tones{.sizing = {.by_tone = options.size_by_tone,
                                      .pens = options.pens,
                                      .is_line = options.path_line,
                                      .spread = made.iterations != 0 ? stippling::Spread::even
                                                                     : stippling::Spread::random,
                                      .fills_overlaps = made.request.mode == Mode::stratified,
                                      .are_strokes = made.are_strokes},
                           .keep_inside = options.keep_inside};
    stippling::set_fields(tones, std::move(importance), options.inks);
    Stippler(made, tones, options, asked).run();
    return made;
}

}  // namespace lacuna
