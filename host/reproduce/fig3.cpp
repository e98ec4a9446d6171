// Figure 3: the error of a disk's area when it is measured by lines, or by a lattice.
//
// The paper defines the error as the "percentage of absolute error between the exact and
// approximate circle areas", averaged over 10,000 samples. It draws curves over m but prints no
// numbers. Here a sample lies anywhere between two lines (section 4.1 interpolates x), or between
// four lattice points. The statements that the paper makes about its curves are checked.
#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

#include "reproduce/disk_area.h"
#include "reproduce/picture.h"
#include "reproduce/reproduce.h"
#include "rounds/random.h"

namespace lacuna::reproduce {
namespace {

constexpr std::uint32_t kLargestM = 60;
constexpr std::uint64_t kFig3Samples = 10'000;
constexpr std::uint32_t kStream = 0xf163;  // a stream of random numbers that no sampler uses

struct Curves {
    std::vector<double> lines;  // percent; entry i is for m = i + 1
    std::vector<double> cells;
    double lines_at(std::uint32_t m) const { return lines[m - 1]; }
    double cells_at(std::uint32_t m) const { return cells[m - 1]; }
};

double unit(std::uint32_t bits) {
    return bits * 0x1p-32;
}

Curves measure(const Setting& setting) {
    Curves curves;
    for (std::uint32_t m = 1; m <= kLargestM; ++m) {
        double lines = 0;
        double cells = 0;
        for (std::uint64_t i = 0; i < kFig3Samples; ++i) {
            const RandomBits random = random_bits(0, i, kStream);
            const double x = unit(static_cast<std::uint32_t>(random.first >> 32U));
            const double y = unit(static_cast<std::uint32_t>(random.second >> 32U));
            lines += std::abs(area_by_lines(m, x) - 1);
            cells += std::abs(area_by_cells(m, x, y) - 1);
        }
        curves.lines.push_back(100 * lines / kFig3Samples);
        curves.cells.push_back(100 * cells / kFig3Samples);
        if (!setting.keep_going(static_cast<double>(m) / kLargestM)) throw Cancelled();
    }
    return curves;
}

// The slope of log(error) against log(m) for m >= 5, by least squares.
double exponent_of(const std::vector<double>& errors) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = 4; i < errors.size(); ++i) {
        const double log_m = std::log(static_cast<double>(i + 1));
        const double log_error = std::log(errors[i]);
        ++n;
        x += log_m;
        y += log_error;
        xx += log_m * log_m;
        xy += log_m * log_error;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

std::string draw(const Curves& curves, files::Medium medium) {
    const auto canvas = drawing::make_canvas(medium, 640, 300);
    const auto panel = [&](double left, const std::string& title,
                           const std::vector<double>& errors) {
        Plot plot(*canvas, {left, 30, 250, 220}, {0, kLargestM, "m"}, {0, 2, "% of the area"});
        plot.draw_axes(title);
        std::vector<Point> curve;
        for (std::size_t i = 0; i < errors.size(); ++i)
            curve.push_back({static_cast<double>(i + 1), errors[i]});
        plot.draw_curve(curve, {kColours[0], 1.2});
    };
    panel(52, "(b) x only: mode lines", curves.lines);
    panel(368, "(c) x and y: mode cells", curves.cells);
    return canvas->finish();
}

}  // namespace

Reproduction fig3(const Setting& setting) {
    const Curves curves = measure(setting);
    constexpr double kNone = -std::numeric_limits<double>::infinity();
    Reproduction made;
    // "the error is reduced as the resolution m increases, but the rate of improvement also
    // decreases as m becomes large" (5.1)
    for (const auto& curve : {std::pair{"x", &curves.lines}, {"x and y", &curves.cells}}) {
        const auto at = [&](std::size_t m) { return (*curve.second)[m - 1]; };
        made.numbers.push_back(in_words(fmt::format("{}: error at m = 30 over m = 10", curve.first),
                                        "reduced", at(30) / at(10), {kNone, 1}));
        made.numbers.push_back(in_words(fmt::format("{}: drop 20 to 30 over 10 to 20", curve.first),
                                        "rate decreases", (at(20) - at(30)) / (at(10) - at(20)),
                                        {kNone, 1}));
    }
    // "Both plots are similar, so the discretization in y does not affect the accuracy much"
    made.numbers.push_back(in_words("exponent of m, x and y less x", "similar",
                                    exponent_of(curves.cells) - exponent_of(curves.lines),
                                    {-0.1, 0.1}));
    made.numbers.push_back(in_words("m = 30: % of the area lost by y", "not much",
                                    curves.cells_at(30) - curves.lines_at(30), {kNone, 0.1}));
    made.data = {{"samples", kFig3Samples},
                 {"unit", "percent of the disk's area, mean absolute error"},
                 {"m", "1 to the number of entries"},
                 {"x_only", curves.lines},
                 {"x_and_y", curves.cells},
                 {"exponent_x_only", exponent_of(curves.lines)},
                 {"exponent_x_and_y", exponent_of(curves.cells)}};
    made.medium = files::Medium::svg;
    made.picture = draw(curves, made.medium);
    return made;
}

}  // namespace lacuna::reproduce
