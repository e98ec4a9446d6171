// The words about a stippling.
#include "cli/reports/stippled.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>

#include "base/number_text.h"
#include "cli/options/common_options.h"

namespace lacuna::cli {

std::string note_on_count(const StippleOptions& options, const Stippling& made) {
    std::string text = words_of(made.layers);
    if (made.is_finished_sooner)
        text += fmt::format(" (finished sooner than in {}: more would not suit)",
                            time_text(*options.plot_seconds));
    if (!text.empty()) return text;
    return options.request.count || options.request.scale || options.plot_seconds
               ? ""
               : " (chosen for the picture: --count gives another number)";
}

std::string plot_text(const StippleOptions& options, const files::PointSet& set,
                      const drawing::Style& style, const Stippling& made) {
    if (made.plot_seconds == 0) return "";
    const double millimetres = made.path_length * drawing::millimetres_per_unit(set, style);
    std::string layers;
    std::size_t drawn = 0;
    for (std::size_t k = 0; k < made.layers.size(); ++k) {
        if (made.layers[k].dots == 0) continue;
        ++drawn;
        layers += fmt::format("{}{} {}", layers.empty() ? "" : ", ", made.layers[k].ink.name,
                              time_text(made.layer_plots[k].seconds));
    }
    if (drawn > 1)
        layers =
            fmt::format(" ({}, and {} change{} of pens)", layers, drawn - 1, drawn == 2 ? "" : "s");
    return fmt::format(
        ", pen path {:.2f} m, about {} on {}{}", millimetres / 1000, time_text(made.plot_seconds),
        options.plotter == Plotter{} ? "an AxiDraw V3" : "this plotter", drawn > 1 ? layers : "");
}

void warn_of_darkness(const CommandLine& line, const std::string& image, const Stippling& made) {
    constexpr double kDark = 0.9;
    const auto has = [&](const char* name) { return line.has(name); };
    if (made.darkness < kDark || has("inks") || has("black") || has("white") ||
        has("auto-levels") || has("min-importance"))
        return;
    std::fputs(fmt::format("lacuna: {}: is {:.0f} % black{}: --auto-levels shows more of it{}\n",
                           shown(image), 100 * made.darkness, has("invert") ? " with --invert" : "",
                           has("invert") ? "" : ", and --invert draws what is light")
                   .c_str(),
               stderr);
}

void warn_of_widths(const drawing::Shown& shown, const Stippling& made,
                    const std::vector<Output>& outputs) {
    const auto is_svg = [](const Output& output) {
        return output.format.medium == files::Medium::svg;
    };
    const bool have_pens = !made.layers.empty() && made.layers.front().ink.pen_mm != 0;
    if (!made.is_for_a_pen || made.pen_mm != 0 || have_pens || made.diameters.empty() ||
        std::none_of(outputs.begin(), outputs.end(), is_svg))
        return;
    const auto [least, most] = std::minmax_element(made.diameters.begin(), made.diameters.end());
    const double mm = drawing::millimetres_per_unit(shown.set, shown.style);
    const std::string narrow = rounded(mm * *least, 2) + "mm", wide = rounded(mm * *most, 2) + "mm";
    if (narrow == wide) return;
    std::fputs(
        fmt::format("lacuna: dots are {} to {} wide, which no one pen draws: for a plotter give "
                    "--pen, such as 0.3mm, which fills wider dots, or --pens\n",
                    narrow, wide)
            .c_str(),
        stderr);
}

}  // namespace lacuna::cli
