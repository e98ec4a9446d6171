// Figure 6: the max, mean and min conflict metrics on one importance field.
//
// The paper's field is not given in numbers. The picture shows shapes.h, 10 : 1; the caption's
// claims about the metrics are measured on a straight edge of the same contrast, see edge.h.
#include <fmt/core.h>

#include <array>
#include <limits>

#include "reproduce/edge.h"
#include "reproduce/picture.h"
#include "reproduce/reproduce.h"
#include "reproduce/sets.h"
#include "reproduce/shapes.h"

namespace lacuna::reproduce {
namespace {

constexpr std::uint32_t kFig6Runs = 40;
constexpr double kScale = 0.012;
constexpr std::array kMetrics{Metric::max, Metric::mean, Metric::min};  // in the order of the paper

std::string draw(const Field& field, Work& work, files::Medium medium) {
    constexpr double kSide = 280;
    constexpr double kUpper = 24;
    const auto canvas = drawing::make_canvas(medium, 2 * kSide + 30, 2 * kSide + 60);
    const auto box_of = [&](std::size_t i) {
        return Rectangle{10 + (kSide + 10) * static_cast<double>(i % 2),
                         i < 2 ? kUpper : kUpper + kSide + 26, kSide, kSide};
    };
    draw_title(*canvas, box_of(0), "(a) density");
    draw_field(*canvas, box_of(0), field);
    for (std::size_t i = 0; i < kMetrics.size(); ++i) {
        Request request;
        request.mode = Mode::cells;
        request.field = &field;
        request.scale = kScale;
        request.paper2011.lines_per_radius = 30;
        request.metric = kMetrics[i];
        request.run_on.backend = "cpu";
        const Sets sets = make_sets(request, 1, work);
        const Rectangle box = box_of(i + 1);
        draw_title(*canvas, box,
                   fmt::format("({}) {}: {} samples", "bcd"[i], name_of(kMetrics[i]),
                               sets.points[0].size()));
        draw_dots(*canvas, box, sets.points[0], 1, 1, kScale / 4);
    }
    return canvas->finish();
}

}  // namespace

Reproduction fig6(const Setting& setting) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    const std::uint32_t runs = setting.runs.value_or(kFig6Runs);
    Work work(setting, 3.0 * (runs + 1));
    Reproduction made;
    std::array<Mean, kMetrics.size()> missing{};
    for (std::size_t i = 0; i < kMetrics.size(); ++i) {
        missing[i] = missing_along_edge({}, kMetrics[i], runs, work);
        made.data["missing_per_radius_of_edge"][std::string(name_of(kMetrics[i]))] = {
            {"mean", missing[i].value}, {"standard_error", missing[i].error}};
    }
    const auto& [max, mean, min] = missing;
    // "samples in the sparse region block those in the dense region, producing artifacts"
    made.numbers = {
        in_words("max: missing per radius of edge", "cut out", max.value, {0, kInfinite}),
        in_words("mean: missing per radius of edge", "same issue", mean.value, {0, kInfinite}),
        // "although this metric produces samples with slightly higher quality" (4.2.1)
        in_words("mean less max", "slightly better", mean.value - max.value, {-kInfinite, 0}),
        // "samples in the sparse region do not block the samples in the dense region"
        in_words("min: missing per radius of edge", "do not block", min.value, {-kInfinite, 0})};
    made.data["runs"] = runs;
    made.medium = files::Medium::png;
    made.picture = draw(shapes(0.1), work, made.medium);
    return made;
}

}  // namespace lacuna::reproduce
