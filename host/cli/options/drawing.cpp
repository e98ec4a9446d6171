// Options of drawing, their checks, and the sizes that follow from them.
#include "cli/options/drawing.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "cli/reports/report.h"
#include "drawing/dot_count.h"

namespace lacuna::cli {
namespace {

constexpr const char* kDrawn[] = {"dot-size", "pens", "paper-size", "margin", "dpi"};
constexpr double kMostPixels = 32767;  // that cairo can draw along a side of an image
// Limits of the dots' ink, as a multiple of the picture's ink; beyond them the user is warned. They
// are one stop of a photograph: 0.5 looks as if it was exposed twice as long, and 2 as if it was
// exposed half as long. Within these limits it may well be what the user wants.
constexpr double kLeastInk = 0.5, kMostInk = 2;

// Rounds a number of dots to three digits, because the number is only advice.
std::uint64_t to_three_digits(double number) {
    const double step = std::pow(10, std::max(0.0, std::floor(std::log10(number)) - 2));
    return static_cast<std::uint64_t>(std::max(1.0, std::round(number / step) * step));
}

// A page without a sheet is a domain whose longer side is as on a domain of 1 x 1.
void check_pixels(const DrawingOptions& options) {
    const double longer_mm = options.paper
                                 ? std::max(options.paper->width_mm, options.paper->height_mm)
                                 : drawing::millimetres_per_unit(files::PointSet{}, {});
    const double most = std::floor(kMostPixels / (longer_mm / drawing::kMillimetresPerInch));
    if (!options.pixels_per_inch) return;
    if (!(*options.pixels_per_inch > 0 && *options.pixels_per_inch <= most))
        throw BadRequest("dpi", fmt::format("{}", *options.pixels_per_inch),
                         fmt::format("must be over 0 and, for this paper, at most {}: {} pixels "
                                     "along its longer side",
                                     most, kMostPixels));
}

std::string text_of(const Pens& pens) {
    return pens.least_mm == pens.most_mm
               ? fmt::format("{:.3g}mm", pens.least_mm)
               : fmt::format("{:.3g}mm to {:.3g}mm", pens.least_mm, pens.most_mm);
}

}  // namespace

Targets targets_of(DrawingOptions& options) {
    Targets targets{{"dpi", &options.pixels_per_inch}};
    targets.merge(recipes::targets_of(options.pens, options.paper));
    return targets;
}

bool has_picture(const std::vector<Output>& outputs) {
    return std::any_of(outputs.begin(), outputs.end(),
                       [](const Output& output) { return output.format.medium.has_value(); });
}

DrawingOptions checked_drawing(const CommandLine& line, DrawingOptions options,
                               const std::vector<Output>& outputs) {
    const auto* const given = std::find_if(std::begin(kDrawn), std::end(kDrawn),
                                           [&](auto name) { return line.has(name); });
    options.are_given = given != std::end(kDrawn);
    const auto is_text = [](const Output& output) { return output.format.name() == "txt"; };
    const std::string with = "with --output " + shown(outputs.front().path);
    if (options.are_given && std::all_of(outputs.begin(), outputs.end(), is_text))
        throw BadRequest(*given, with,
                         "is for pictures, and for files with columns for dots: not for .txt");
    const auto is_png = [](const Output& output) {
        return output.format.medium == drawing::Medium::png;
    };
    if (line.has("dpi") && std::none_of(outputs.begin(), outputs.end(), is_png))
        throw BadRequest("dpi", with, "is for .png");
    if (options.paper) drawing::check(*options.paper);
    check_pixels(options);
    return options;
}

drawing::Style style_of(const DrawingOptions& options, const Domain& domain) {
    drawing::Style style;
    if (options.paper) style.sheet = drawing::turned(*options.paper, domain);
    style.pixels_per_inch = options.pixels_per_inch;
    return style;
}

void warn_of_ink(const DrawingOptions& options, std::size_t count, double suits) {
    if (!options.pens || suits == 0 || count == 0) return;
    const double ink = static_cast<double>(count) / suits;
    if (ink >= kLeastInk && ink <= kMostInk) return;
    const std::string percent =
        ink < 0.1 ? fmt::format("{:.2g}", 100 * ink) : fmt::format("{:.0f}", 100 * ink);
    const double factor = 1 / std::sqrt(ink);
    const Pens pens{options.pens->least_mm * factor, options.pens->most_mm * factor};
    const std::string size = pens.least_mm == pens.most_mm
                                 ? fmt::format("{:.2g}mm", pens.least_mm)
                                 : fmt::format("{:.2g}mm..{:.2g}mm", pens.least_mm, pens.most_mm);
    const std::string or_else =
        options.pens->widths_mm.empty() ? fmt::format(", or --dot-size {},", size) : "";
    std::fputs(fmt::format("lacuna: {} dots of {} have {} % of the picture's ink: about {} dots{} "
                           "would suit\n",
                           count, text_of(*options.pens), percent, to_three_digits(suits), or_else)
                   .c_str(),
               stderr);
}

void warn_of_ink(const DrawingOptions& options, const Request& request, const Field* tone,
                 std::size_t count, const drawing::Style& style) {
    if (!options.pens || tone == nullptr) return;
    warn_of_ink(options, count,
                drawing::dots_for_ink(*tone, request.domain, {.pens = options.pens}, style));
}

Json json_of_pens(const std::optional<Pens>& pens) {
    if (!pens) return "radius";
    if (pens->least_mm == pens->most_mm) return pens->least_mm;
    if (!pens->widths_mm.empty()) return pens->widths_mm;
    return {pens->least_mm, pens->most_mm};
}

void write_set(Writing& writing, const DrawingOptions& options, const std::vector<Output>& outputs,
               files::PointSet set, drawing::Style style, const FindDiameters& find_diameters) {
    std::vector<double> diameters;
    if (options.pens && options.pens->least_mm == options.pens->most_mm)
        diameters.assign(set.points.size(),
                         options.pens->least_mm / drawing::millimetres_per_unit(set, style));
    else if (options.are_given || has_picture(outputs))
        diameters = find_diameters();
    style.diameters = diameters;
    files::Dots dots;
    if (options.are_given) {
        dots = drawing::dots_of(set, style);
        set.dots = &dots;
    }
    for (const Output& output : outputs)
        writing.add(output.path, [&] {
            return output.format.medium ? drawing::draw(set, *output.format.medium, style)
                                        : files::encode(set, output.format);
        });
    writing.write();
}

}  // namespace lacuna::cli
