// lacuna::stipple: the number of dots, the dots themselves, their sizes and their order.
#include <lacuna/stipple.h>

#include <fmt/core.h>

#include <algorithm>
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
    return line;
}

void check_inks(const StippleOptions& options) {
    const auto& counts = options.ink_counts;
    if (counts.empty()) return;
    if (counts.size() != options.inks.size())
        throw BadRequest("ink-counts", fmt::format("{} numbers", counts.size()),
                         fmt::format("must be one for each ink, {}", options.inks.size()));
    if (sum_of(counts) == 0) throw BadRequest("ink-counts", "0", "must not be 0 for all inks");
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
    const recipes::Given given{.is_picture = true,
                               .has_inks = !options.inks.empty(),
                               .has_ellipses = has_ellipses(options),
                               .mode = options.start,
                               .metric = options.metric,
                               .relax = options.relax};
    Stippling made{.request = options.request};
    made.iterations = recipes::relax_of(given);
    made.is_for_a_pen = options.pen_path;
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
        if (options_.pen_path) order_for_a_pen();
        find_sizes();
        if (!request().field->stretches.empty())
            made_.ellipses = ellipses_of(made_.result.points, *request().field, made_.result.scale,
                                         request().domain);
        made_.layers = tones_.layers;
        request().field = nullptr;
    }

private:
    Request& request() { return made_.request; }

    files::PointSet dots() {
        files::PointSet set{made_.result.points, request().domain};
        set.layers = tones_.layers;
        return set;
    }

    // Sets the number of dots, in all and of each ink.
    void choose_count() {
        const auto& counts = options_.ink_counts;
        if (!counts.empty())
            request().count = sum_of(counts);
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
            const std::size_t first = ordered.size();
            for (const std::uint32_t index : pen::pen_path(part.points, may_go_on))
                ordered.push_back(part.points[index]);
            made_.admitted_length += pen::path_length(part.points);
            made_.path_length += pen::path_length(std::span(ordered).subspan(first));
        });
        made_.result.points = std::move(ordered);
        observer_.end(Verb::pen_path);
    }

    void find_sizes() {
        const std::optional<Pens>& pens = options_.pens;
        // Inks whose dots differ in size have no one number.
        if (pens && !(tones_.has_inks() && tones_.sizing.varies()))
            made_.dots_for_ink =
                drawing::dots_for_ink(tones_.all(), request().domain, *pens, style_);
        made_.diameters = drawing::diameters_of(tones_, dots(), style_);
    }

    Stippling& made_;
    drawing::Tones& tones_;
    const StippleOptions& options_;
    Observer& observer_;
    drawing::Style style_;
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
        .sizing = {options.size_by_tone, options.pens},
        .keep_inside = options.keep_inside,
        .spread = made.iterations != 0 ? drawing::Spread::even : drawing::Spread::random};
    drawing::set_fields(tones, std::move(importance), options.inks);
    Stippler(made, tones, options, asked).run();
    return made;
}

}  // namespace lacuna
