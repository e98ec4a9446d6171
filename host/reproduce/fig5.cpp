// Figure 5: sets that are not maximal; lines are picked by the cdf, or uniformly.
//
// r = 0.01 on the torus, 6,000 of about 6,900 samples. Uniform-x makes the density along x uneven,
// which shows in the periodogram at ky = 0. In the paper's picture this line is upright, so its
// axes must be exchanged; here kx is drawn upwards, too.
#include <fmt/core.h>

#include <limits>

#include "reproduce/picture.h"
#include "reproduce/reproduce.h"
#include "reproduce/sets.h"

namespace lacuna::reproduce {
namespace {

constexpr double kFig5Radius = 0.01;
constexpr std::uint64_t kFig5Samples = 6000;
constexpr std::uint32_t kFig5Runs = 10;

struct Method {
    std::string name;
    analysis::Analysis analysis;
};

Method make(const Setting& setting, bool uniform_x, Work& work) {
    Request request = lines_request(kFig5Radius, Boundary::torus);
    request.limit = kFig5Samples;
    request.paper2011.uniform_x = uniform_x;
    if (uniform_x) request.run_on.backend = "reference";
    const Sets sets = make_sets(request, setting.runs.value_or(kFig5Runs), work);
    return {uniform_x ? "uniform-x" : "cdf", analyse_on_torus(sets.points, kFig5Radius, work)};
}

std::string draw(std::span<const Method> methods, files::Medium medium) {
    const auto canvas = drawing::make_canvas(medium, 640, 520);
    double top = 30;
    for (std::size_t i = 0; i < methods.size(); ++i, top += 250) {
        const Method& method = methods[i];
        const Rectangle square{20, top, 195, 195};
        draw_title(*canvas, square, "Periodogram, " + method.name);
        draw_periodogram(*canvas, square, method.analysis.spectrum, 1.25, 1, Turned::yes);
        canvas->text({square.left + square.width / 2, square.bottom() + 12},
                     "ky to the right, kx upwards, to 1.25 \u221aN", {8, Anchor::middle, kInk});
        draw_radial_power(*canvas, {262, top, 160, 195}, "Radial power", method.analysis.radial,
                          kColours[i]);
        draw_anisotropy(*canvas, {470, top, 160, 195}, "Anisotropy", method.analysis, kColours[i]);
    }
    return canvas->finish();
}

}  // namespace

Reproduction fig5(const Setting& setting) {
    Work work(setting, 2.0 * setting.runs.value_or(kFig5Runs));
    const std::array methods{make(setting, false, work), make(setting, true, work)};
    // Without bias the line's power over the rest is 1, within this standard error.
    const auto& line = *methods[0].analysis.horizontal_line;
    const double error = 1 / std::sqrt(static_cast<double>(line.modes * methods[0].analysis.sets));
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    Reproduction made;
    made.numbers = {
        in_words("cdf: power on the line over the rest", "reasonable", line.ratio,
                 {1 - 4 * error, 1 + 4 * error}),
        in_words("uniform-x: power on the line over the rest", "significant bias",
                 methods[1].analysis.horizontal_line->ratio, {1 + 10 * error, kInfinite}),
        in_words("uniform-x: power on the other line", "one line",
                 methods[1].analysis.vertical_line->ratio, {1 - 4 * error, 1 + 4 * error})};
    for (const Method& method : methods) made.data[method.name] = json_of(method.analysis, 2);
    made.medium = files::Medium::svg;
    made.picture = draw(methods, made.medium);
    return made;
}

}  // namespace lacuna::reproduce
