// The pen's path through stippled dots, and the report of `lacuna stipple`.
#include "cli/commands/stipple_work.h"

#include <fmt/core.h>

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/reports/report.h"
#include "cli/terminal/progress_bar.h"
#include "cli/terminal/stopwatch.h"
#include "drawing/page.h"
#include "drawing/pen/pen_path.h"

namespace lacuna::cli {
namespace {

Json json_of(const DrawingOptions& options, const drawing::Style& style) {
    return {{"dot_size_mm", json_of_pens(options.pens)},
            {"paper_mm",
             style.sheet ? Json({style.sheet->width_mm, style.sheet->height_mm}) : Json(nullptr)},
            {"margin_mm", options.margin_mm},
            {"dpi", style.pixels_per_inch}};
}

}  // namespace

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
    files::PointSet set{points};
    set.layers = layers;
    drawing::for_each_layer(
        set, {}, [&](std::size_t, const auto& part, const auto&) { order(part.points); });
    work.path_seconds = stopwatch.seconds_so_far();
    points = std::move(ordered);
}

Json json_of(const StippleCommand& options) {
    Json json{{"image", options.picture.path}};
    json.update(json_of_importance(options.picture.importance));
    json["relax"] = options.relax;
    if (!options.inks.inks.empty()) json.update(json_of(options.inks));
    json["pen_path"] = options.pen_path;
    if (options.keep_inside) json["keep_inside"] = true;
    if (options.size_by_tone != 0) json["size_by_tone"] = options.size_by_tone;
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

std::string path_text(const StippleCommand& options, const std::vector<Output>& outputs,
                      const files::PointSet& set, const drawing::Style& style, const Work& work) {
    if (!options.pen_path) return "";
    if (!has_picture(outputs))
        return fmt::format(", pen path {:.4g} longer sides", work.path_length);
    return fmt::format(", pen path {:.2f} m",
                       work.path_length * drawing::millimetres_per_unit(set, style) / 1000);
}

}  // namespace lacuna::cli
