// The layout of the plot sheet's four panels.
#include "analysis/sheet.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/pairs.h"
#include "drawing/canvas.h"
#include "drawing/plot.h"

namespace lacuna::analysis {
namespace {

using drawing::Anchor;
using drawing::Canvas;
using drawing::Grid;
using drawing::Plot;
using drawing::Position;
using drawing::Rectangle;

constexpr double kPageWidth = 640;
constexpr double kPageHeight = 594;
constexpr double kPanelWidth = 252;
constexpr double kUpperHeight = 252;
constexpr double kLowerHeight = 176;
constexpr double kLeft = 52;
constexpr double kRight = 368;
constexpr double kUpper = 66;
constexpr double kLower = 374;
constexpr Colour kInk{0x22, 0x22, 0x22};
constexpr Colour kCurve{0x1f, 0x4e, 0x9c};
constexpr double kWhitePower = 3;

// The largest rectangle of that shape that fits into a panel, centred.
Rectangle fitted(const Rectangle& panel, double width, double height) {
    const double scale = std::min(panel.width / width, panel.height / height);
    return {panel.left + (panel.width - scale * width) / 2,
            panel.top + (panel.height - scale * height) / 2, scale * width, scale * height};
}

std::string heading(const Analysis& analysis) {
    const Counts& counts = analysis.counts;
    const std::string of = counts.least == counts.most
                               ? fmt::format("{} point{}", counts.most, counts.most == 1 ? "" : "s")
                               : fmt::format("{} to {} points", counts.least, counts.most);
    const std::string sets =
        analysis.sets == 1 ? of : fmt::format("{} sets of {}", analysis.sets, of);
    return fmt::format("{}, {} {:.6g} \u00d7 {:.6g}", sets, analysis.domain.torus ? "torus" : "box",
                       analysis.domain.width, analysis.domain.height);
}

std::string numbers(const Analysis& analysis) {
    std::string line;
    const auto add = [&](const std::string& piece) {
        line += (line.empty() ? "" : "   \u00b7   ") + piece;
    };
    if (analysis.radius)
        add(fmt::format("r = {:.6g}, N r\u00b2 / area = {:.4f}", *analysis.radius,
                        *analysis.count_times_squared_radius));
    if (analysis.distances)
        add(fmt::format("relative radius {:.3f}", analysis.distances->relative_radius));
    if (analysis.effective_nyquist)
        add(fmt::format("effective Nyquist {:.3f}", *analysis.effective_nyquist));
    if (analysis.oscillations) add(fmt::format("oscillations {:.3f}", *analysis.oscillations));
    if (analysis.bond_order) add(fmt::format("|\u03c8\u2086| {:.3f}", analysis.bond_order->local));
    return line;
}

// The name of an axis that begins at the corner: its numbers would be too long for the sheet.
std::string axis_from(const char* name, double corner) {
    if (corner == 0) return name;
    return fmt::format("{} {} {:.10g}", name, corner < 0 ? "+" : "\u2212", std::abs(corner));
}

void draw_points(Canvas& canvas, const Analysis& analysis, std::span<const Point> points) {
    const Domain& domain = analysis.domain;
    const Rectangle box =
        fitted({kLeft, kUpper, kPanelWidth, kUpperHeight}, domain.width, domain.height);
    Plot plot(canvas, box, {0, domain.width, axis_from("x", domain.x0)},
              {0, domain.height, axis_from("y", domain.y0)});
    plot.draw_axes(analysis.sets == 1 ? "Points" : "Points of the first set", Grid::none);
    std::vector<Position> positions;
    positions.reserve(points.size());
    for (const Point& point : points) {
        const Point way = domain.from_corner(point);
        positions.push_back({box.left + way.x / domain.width * box.width,
                             box.bottom() - way.y / domain.height * box.height});
    }
    constexpr double kMaximalRadius = 0.8346;  // of a maximal set, in mean spacings: sqrt(0.69656)
    const double radius =
        analysis.radius.value_or(kMaximalRadius * mean_spacing(domain, points.size()));
    const double shorter = std::min(domain.width, domain.height);
    canvas.dots(positions, std::min(radius, shorter) / 3 * (box.width / domain.width), box);
}

// One pixel for each frequency from -farthest to farthest; DC is black.
drawing::Image periodogram_image(const Spectrum& spectrum, double farthest) {
    const double unit = std::sqrt(spectrum.count);
    const auto reach = [&](double step, int most) {
        return std::clamp(static_cast<int>(std::lround(farthest * unit / step)), 1, most);
    };
    const int kx_max = reach(spectrum.magnitude(1, 0), spectrum.range.kx_max);
    const int ky_max = reach(spectrum.magnitude(0, 1), spectrum.range.ky_max);
    drawing::Image image{2 * kx_max + 1, 2 * ky_max + 1, {}};
    for (int ky = ky_max; ky >= -ky_max; --ky)
        for (int kx = -kx_max; kx <= kx_max; ++kx)
            image.greys.push_back(static_cast<std::uint8_t>(
                std::lround(255 * std::min(1.0, spectrum.power(kx, ky) / kWhitePower))));
    return image;
}

void draw_periodogram(Canvas& canvas, const Analysis& analysis) {
    const Spectrum& spectrum = analysis.spectrum;
    const drawing::Image image = periodogram_image(spectrum, analysis.max_frequency);
    // Half the size of the image: its outer pixels reach half a frequency beyond theirs.
    const double unit = std::sqrt(spectrum.count);
    const double x = image.width / 2.0 * spectrum.magnitude(1, 0) / unit;
    const double y = image.height / 2.0 * spectrum.magnitude(0, 1) / unit;
    const Rectangle box = fitted({kRight, kUpper, kPanelWidth, kUpperHeight}, x, y);
    canvas.image(box, image);
    Plot plot(canvas, box, {-x, x, "kx / \u221aN"}, {-y, y, "ky / \u221aN"});
    plot.draw_axes(fmt::format("Periodogram, 0 black to {:g} white", kWhitePower), Grid::none);
}

// The exponents of the least and greatest radial powers, if the least is so low that only a
// logarithmic axis shows it.
std::optional<std::pair<double, double>> exponents_of(const Radial& radial) {
    constexpr double kLow = 1e-4, kLeastShown = 1e-12;
    double least = 1;
    for (const Annulus& annulus : radial.annuli) least = std::min(least, annulus.power);
    if (least > kLow) return std::nullopt;
    return std::pair{std::floor(std::log10(std::max(least, kLeastShown))),
                     std::ceil(std::log10(std::max(radial.peak().power, 1.0)))};
}

void draw_radial_power(Canvas& canvas, const Analysis& analysis) {
    const Radial& radial = analysis.radial;
    const auto exponents = exponents_of(radial);
    constexpr double kTallest = 10;
    constexpr double kLowest = 2;
    const Annulus& peak = radial.peak();
    const double top = std::clamp(std::ceil(peak.power * 2.2) / 2, kLowest, kTallest);
    const drawing::Axis power =
        exponents ? drawing::Axis{exponents->first, exponents->second, "power", true}
                  : drawing::Axis{0, top, "power"};
    Plot plot(canvas, {kLeft, kLower, kPanelWidth, kLowerHeight},
              {0, analysis.max_frequency, "k / \u221aN"}, power);
    plot.draw_axes(fmt::format("Radial power, peak {:.4g} at {:.3g}", peak.power, peak.frequency));
    plot.draw_level(exponents ? 0 : 1, "1: independent points");
    std::vector<Point> curve;
    for (const Annulus& annulus : radial.annuli)
        curve.push_back(
            {annulus.frequency,
             exponents ? std::max(std::log10(annulus.power), exponents->first) : annulus.power});
    plot.draw_curve(curve, {kCurve, 1.2});
}

void draw_anisotropy(Canvas& canvas, const Analysis& analysis) {
    const double expected = 10 * std::log10(1 / static_cast<double>(analysis.sets));
    constexpr double kAround = 12;
    Plot plot(canvas, {kRight, kLower, kPanelWidth, kLowerHeight},
              {0, analysis.max_frequency, "k / \u221aN"},
              {std::floor((expected - kAround) / 5) * 5, std::ceil((expected + kAround) / 5) * 5,
               "anisotropy (dB)"});
    const auto mean = analysis.radial.mean_anisotropy_db();
    plot.draw_axes(mean ? fmt::format("Radial anisotropy, mean {} dB",
                                      drawing::with_minus(fmt::format("{:.2f}", *mean)))
                        : "Radial anisotropy: none, no spread of power");
    std::vector<Point> curve;
    const auto draw = [&] {
        plot.draw_curve(curve, {kCurve, 1.2});
        curve.clear();
    };
    for (const Annulus& annulus : analysis.radial.annuli) {
        if (annulus.anisotropy_db) {
            curve.push_back({annulus.frequency, *annulus.anisotropy_db});
        } else {
            draw();  // leaves a gap
        }
    }
    draw();
    plot.draw_level(expected, fmt::format("{} dB: {} set{} without direction",
                                          drawing::with_minus(fmt::format("{:.3g}", expected)),
                                          analysis.sets, analysis.sets == 1 ? "" : "s"));
}

}  // namespace

std::string draw_sheet(const Analysis& analysis, std::span<const Point> points,
                       files::Medium medium) {
    const std::unique_ptr<Canvas> canvas = drawing::make_canvas(medium, kPageWidth, kPageHeight);
    canvas->text({kLeft, 24}, heading(analysis), {13, Anchor::start, kInk, true});
    canvas->text({kLeft, 41}, numbers(analysis), {8.5, Anchor::start, kInk});
    draw_points(*canvas, analysis, points);
    draw_periodogram(*canvas, analysis);
    draw_radial_power(*canvas, analysis);
    draw_anisotropy(*canvas, analysis);
    return canvas->finish();
}

}  // namespace lacuna::analysis
