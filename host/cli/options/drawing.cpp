// Options of drawing, their checks, and the sizes that follow from them.
#include "cli/options/drawing.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/number_text.h"
#include "cli/reports/report.h"
#include "options/read.h"
#include "options/words.h"
#include "stipple/dot_count.h"

namespace lacuna::cli {
namespace {

constexpr const char* kDrawn[] = {"dot-size", "pens", "pen", "paper-size", "margin", "dpi"};
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

std::string text_of(double least_mm, double most_mm, const char* to, int digits) {
    return least_mm == most_mm
               ? fmt::format("{:.{}g}mm", least_mm, digits)
               : fmt::format("{:.{}g}mm{}{:.{}g}mm", least_mm, digits, to, most_mm, digits);
}

// The paper on which dots, which have `part` of what they need on the present one, have the
// picture's ink: one with a name if that comes near.
std::string paper_that_suits(const DrawingOptions& options, const Inked& inked, double part) {
    constexpr double kNear = 1.5, kLeastSide = 50;
    const double around = 2 * (options.paper ? options.paper->margin_mm : 0) + inked.widest_pen_mm;
    drawing::Style style;
    const auto scale_on = [&](std::optional<Paper> paper) {
        if (paper) {
            style.sheet = drawing::turned(*paper, inked.domain);
            style.sheet->margin_mm = around / 2;
        }
        return drawing::millimetres_per_unit(files::PointSet{{}, inked.domain}, style);
    };
    const double scale = scale_on(options.paper);
    double nearest = kNear;
    std::string best;
    for (const std::string_view name : options::words_of(options::Words::papers)) {
        const double ratio = scale / scale_on(options::read_paper("paper-size", std::string(name)));
        const double ink = part * ratio * ratio;
        if (!(ratio > 0 && std::max(ink, 1 / ink) < nearest)) continue;
        nearest = std::max(ink, 1 / ink);
        best = "--paper-size " + std::string(name);
    }
    if (!best.empty() || !options.paper) return best;
    const auto side = [&](double mm) {
        return std::round((mm - around) * std::sqrt(part) + around);
    };
    const Paper sheet = drawing::turned(*options.paper, inked.domain);
    const double width = side(sheet.width_mm), height = side(sheet.height_mm);
    return std::min(width, height) < kLeastSide
               ? ""
               : fmt::format("--paper-size {}x{}mm", width, height);
}

}  // namespace

Targets targets_of(DrawingOptions& options) {
    Targets targets{{"dpi", &options.pixels_per_inch}};
    targets.merge(options::targets_of(options.pens, options.paper));
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
        return output.format.medium == files::Medium::png;
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

void warn_of_ink(const DrawingOptions& options, const Inked& inked) {
    if (inked.suits == 0 || inked.dots == 0) return;
    const double part = static_cast<double>(inked.dots) / inked.suits;
    const double ink = inked.are_line ? std::sqrt(part) : part;
    if (ink >= kLeastInk && ink <= kMostInk) return;
    const std::optional<Pens>& pens = options.pens;
    std::vector<std::string> advice{fmt::format("about {} dots", to_three_digits(inked.suits))};
    if (pens && pens->widths_mm.empty()) {
        const double factor = 1 / std::sqrt(part);
        advice.push_back("--dot-size " +
                         text_of(pens->least_mm * factor, pens->most_mm * factor, "..", 2));
    }
    if (const std::string paper = paper_that_suits(options, inked, part); !paper.empty())
        advice.push_back(paper);
    const std::string percent =
        ink < 0.1 ? fmt::format("{:.2g}", 100 * ink) : fmt::format("{:.0f}", 100 * ink);
    const std::string pen = pens ? text_of(pens->least_mm, pens->most_mm, " to ", 3) : "these pens";
    const std::string drawn = inked.are_line
                                  ? fmt::format("lines of {} through {} dots", pen, inked.dots)
                                  : fmt::format("{} dots of {}", inked.dots, pen);
    // Found by looking: with 14 to 40 % of the ink dots of a photograph, or one line, look flat by
    // its numbers. With 1.5 they look a little less flat, and with 3 faces lose their features.
    std::string contrast;
    if (ink < kLeastInk && !inked.has_gamma) {
        contrast = "; with this ink --gamma 2 keeps more contrast";
        if (pens && pens->least_mm == pens->most_mm && !inked.are_line)
            contrast += ", and --size-by-tone 0.5 --pen " + pen +
                        " in place of --dot-size draws wider dots with this pen";
    }
    std::fputs(
        fmt::format("lacuna: {} have {} % of the picture's ink: {} would suit{}\n", drawn, percent,
                    options::listed(std::vector<std::string_view>(advice.begin(), advice.end())),
                    contrast)
            .c_str(),
        stderr);
}

void warn_of_ink(const DrawingOptions& options, const Request& request, const Field* tone,
                 std::size_t count, const drawing::Style& style) {
    if (!options.pens || tone == nullptr) return;
    warn_of_ink(options, {.dots = count,
                          .suits = stippling::dots_for_ink(*tone, request.domain,
                                                           {.pens = options.pens}, style),
                          .domain = request.domain,
                          .widest_pen_mm = 0});
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
        writing.add(output.path, [&] { return drawing::encode(set, output.format, style); });
    writing.write();
}

void finish(Interruption& interruption, const CommonOptions& options, const DrawingOptions& drawing,
            const std::vector<Output>& outputs, const Ready& ready) {
    Writing writing(interruption);
    if (!options.report.empty()) writing.add(options.report, ready.report);
    write_set(writing, drawing, outputs, ready.set, ready.style, ready.find_diameters);
    sum_up({outputs, options.report, options.quiet}, ready.words, ready.set.points.empty());
}

}  // namespace lacuna::cli
