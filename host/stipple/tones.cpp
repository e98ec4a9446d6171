// Computes ink by ink what dot_size, dot_count and keep_inside compute for one field.
#include "stipple/tones.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "base/number_text.h"
#include "base/polling.h"
#include "drawing/page.h"
#include "stipple/dot_count.h"
#include "stipple/pen/plotting_time.h"

namespace lacuna::stippling {
namespace {

// The diameters that the tones ask for, whether dots overhang an edge or not.
std::vector<double> toned_diameters(const Tones& tones, const files::PointSet& set,
                                    const drawing::Style& style) {
    const double scale = millimetres_per_unit(set, style);
    std::vector<double> all;
    files::PointSet dots = set;
    dots.layers = tones.layers;
    for_each_layer(
        dots, drawing::Style{}, [&](std::size_t k, const auto& part, const drawing::Style&) {
            const Field& field = tones.fields[k];
            const Sizing sizing = tones.sizing_of(k);
            const std::vector<double> diameters =
                sizing.pens ? pen_diameters(part.points, field, set.domain, *sizing.pens, scale)
                            : dot_diameters(part.points, field, set.domain, sizing.spread, sizing);
            all.insert(all.end(), diameters.begin(), diameters.end());
        });
    return all;
}

}  // namespace

Sizing Tones::sizing_of(std::size_t k) const {
    Sizing one = sizing;
    const double pen_mm = has_inks() ? layers[k].ink.pen_mm : 0;
    if (pen_mm != 0) one.pens = Pens{pen_mm, pen_mm};
    if (!shares.empty()) one.shares = shares[k];
    return one;
}

bool Tones::has_pens() const {
    for (std::size_t k = 0; k < fields.size(); ++k)
        if (!sizing_of(k).pens) return false;
    return true;
}

void set_fields(Tones& tones, std::vector<Field> fields, std::span<const Ink> inks) {
    tones.fields = std::move(fields);
    tones.sizing.solid_black = tones.keep_inside;
    for (const Ink& ink : inks) tones.layers.push_back({ink, 0});
    const bool has_pen =
        std::any_of(inks.begin(), inks.end(), [](const Ink& ink) { return ink.pen_mm != 0; });
    if (tones.sizing.varies() || has_pen)
        for (std::size_t k = 0; k < tones.fields.size(); ++k)
            tones.varied.push_back(density_of(tones.fields[k], tones.sizing_of(k)));
    if (inks.empty()) return;
    tones.sum = tones.fields.front();
    std::vector<double>& sum = tones.sum.importance;
    for (const Field& field : std::span(tones.fields).subspan(1))
        std::transform(sum.begin(), sum.end(), field.importance.begin(), sum.begin(), std::plus());
}

std::vector<files::Layer> layers_of_pens(const Tones& tones, const Domain& domain,
                                         std::span<Point> points) {
    std::vector<files::Layer> layers;
    std::size_t first = 0;
    bool are_several = false;
    for (std::size_t k = 0; k < tones.fields.size(); ++k) {
        const Sizing sizing = tones.sizing_of(k);
        const files::Layer ink =
            tones.has_inks() ? tones.layers[k] : files::Layer{{}, points.size()};
        auto rest = points.subspan(first, ink.dots);
        first += rest.size();
        if (!sizing.pens || sizing.pens->widths_mm.empty()) {
            layers.push_back(ink);
            continue;
        }
        are_several = true;
        for (const double width : sizing.pens->widths_mm) {
            const auto is_its = [&](const Point& point) {
                return width_at(*sizing.pens, importance_at(point, tones.fields[k], domain)) ==
                       width;
            };
            const auto end = std::stable_partition(rest.begin(), rest.end(), is_its);
            const std::string pen = lacuna::rounded(width, 6) + "mm";
            const std::string name = ink.ink.name.empty() ? pen : ink.ink.name + " " + pen;
            const auto dots = static_cast<std::size_t>(end - rest.begin());
            layers.push_back({{name, ink.ink.colour, width}, dots});
            rest = rest.subspan(dots);
        }
    }
    return are_several ? layers : std::vector<files::Layer>{};
}

double dots_for_ink(const Tones& tones, const Domain& domain, const drawing::Style& style) {
    if (!tones.has_pens()) return 0;
    double all = 0;
    for (std::size_t k = 0; k < tones.fields.size(); ++k)
        all += dots_for_ink(tones.fields[k], domain, tones.sizing_of(k), style);
    return all;
}

std::uint64_t suiting_count(const Tones& tones, const Domain& domain, const drawing::Style& style) {
    if (!tones.has_pens()) return default_count(tones.all(), domain, tones.sizing, style);
    std::uint64_t all = 0;
    for (std::size_t k = 0; k < tones.fields.size(); ++k)
        all += default_count(tones.fields[k], domain, tones.sizing_of(k), style);
    return std::min(all, static_cast<std::uint64_t>(kMostDots));
}

// About how long the path through n dots is, in mm, over sqrt(n), and the same times the width of
// each ink's pen, in mm^2. With n dots of density d(x) in all, those of ink k d_k, the path of ink
// k is kPath times the integral of sqrt(d_k).
struct PathOfOne {
    double length;
    double ink;
};
PathOfOne path_of_one(const Tones& tones, const Domain& domain, const drawing::Style& style) {
    constexpr double kPath = 1;  // measured: 0.98 to 1.01 times as long in pictures of two kinds
    double sum = 0, roots = 0, ink = 0;
    for (std::size_t k = 0; k < tones.fields.size(); ++k) {
        const Field& field = tones.densities()[k];
        double own = 0;
        for_each_polled(field.importance.size(), ask, [&](std::size_t i) {
            sum += field.importance[i];
            own += std::sqrt(field.importance[i]);
        });
        roots += own;
        const std::optional<Pens> pens = tones.sizing_of(k).pens;
        ink += own * (pens ? pens->least_mm : 0);
    }
    const auto pixels = static_cast<double>(tones.all().importance.size());
    const double pixel_area = domain.width * domain.height / pixels;
    const double factor = kPath * std::sqrt(pixel_area / sum) *
                          millimetres_per_unit(files::PointSet{{}, domain}, style);
    return {factor * roots, factor * ink};
}

// How long the pen of a style draws a dot.
double seconds_of_dot(double diameter_mm, const drawing::Style& style, const Plotter& plotter) {
    return pen::seconds_around(plotter, drawing::pen_dot(diameter_mm, style.pen_mm, style.circles));
}

// The mean of that for dots of the tones' pens.
double seconds_of_mean_dot(const Tones& tones, const drawing::Style& style,
                           const Plotter& plotter) {
    double sum = 0, seconds = 0;
    for (std::size_t k = 0; k < tones.fields.size(); ++k) {
        const std::vector<double>& density = tones.densities()[k].importance;
        for_each_polled(density.size(), ask, [&](std::size_t i) {
            if (density[i] == 0) return;
            const double width = width_at(*tones.sizing.pens, tones.fields[k].importance[i]);
            sum += density[i];
            seconds += density[i] * seconds_of_dot(width, style, plotter);
        });
    }
    return seconds / sum;
}

std::uint64_t plotted_count(const Tones& tones, const Domain& domain, const drawing::Style& style,
                            const Plotter& plotter, double seconds) {
    constexpr double kLonger = 1.02;  // so that no path is longer than expected
    const double path = kLonger * path_of_one(tones, domain, style).length;
    const double mm = millimetres_per_unit(files::PointSet{{}, domain}, style);
    const double ink = ink_of(tones, domain) * mm * mm;
    const double strokes = tones.sizing.are_strokes ? ink / tones.sizing.pens->least_mm : 0;
    constexpr double kWider = 1.12;  // as dots of the library's choice are in black
    const bool has_pen = style.pen_mm != 0, is_given_pen = has_pen && !tones.has_pens();
    const double mean = has_pen && !is_given_pen ? seconds_of_mean_dot(tones, style, plotter) : 0;
    const auto drawn = [&](double dots) {
        if (!is_given_pen) return mean;
        return seconds_of_dot(kWider * std::sqrt(4 / std::numbers::pi * ink / dots), style,
                              plotter);
    };
    const auto seconds_for = [&](double dots) {
        const double way = path / std::sqrt(dots);
        if (tones.sizing.is_line)
            return static_cast<double>(tones.fields.size()) * plotter.seconds_per_dot +
                   dots * pen::usual_seconds_down(plotter, way);
        return dots * (plotter.seconds_per_dot + pen::seconds_up(plotter, way) +
                       pen::seconds_straight_down(plotter, strokes / dots) + drawn(dots));
    };
    double least = 1, most = kMostDots;
    if ((strokes > 0 || is_given_pen) && seconds_for(least) > seconds)
        throw BadRequest(
            "plot-time", time_text(seconds),
            fmt::format("the {} alone take {}: give a wider --{}",
                        is_given_pen ? "dots" : "strokes", time_text(seconds_for(least)),
                        is_given_pen ? "pen" : "dot-size"));
    while (most - least > 0.5) {
        const double middle = (least + most) / 2;
        (seconds_for(middle) <= seconds ? least : most) = middle;
    }
    return static_cast<std::uint64_t>(most == kMostDots ? most : least);
}

double ink_of(const Tones& tones, const Domain& domain) {
    double layers = 0;
    for (std::size_t k = 0; k < tones.fields.size(); ++k) {
        const Sizing sizing = tones.sizing_of(k);
        const std::vector<double>& importance = tones.fields[k].importance;
        for_each_polled(importance.size(), ask,
                        [&](std::size_t i) { layers += sizing.layers_at(importance[i]); });
    }
    const auto pixels = static_cast<double>(tones.all().importance.size());
    return layers / pixels * domain.width * domain.height;
}

std::uint64_t count_of_line(const Tones& tones, const Domain& domain, const drawing::Style& style) {
    const double scale = millimetres_per_unit(files::PointSet{{}, domain}, style);
    const double ink = ink_of(tones, domain) * scale * scale;
    const double root = ink / path_of_one(tones, domain, style).ink;
    return static_cast<std::uint64_t>(std::clamp(std::round(root * root), 1.0, kMostDots));
}

void share_dots(Tones& tones, std::uint64_t dots) {
    const std::vector<std::uint64_t> shares = dots_by_ink(dots, tones.densities());
    for (std::size_t k = 0; k < shares.size(); ++k) tones.layers[k].dots = shares[k];
}

void suit_narrow_shapes(Tones& tones, const Domain& domain, std::uint64_t dots) {
    constexpr double kLeastShare = 1.0 / 9;
    constexpr double kMostPixels = 16;  // wider shapes are not narrow: dots fit into them
    constexpr int kSteps = 8;
    if (!tones.keep_inside || tones.sizing.is_line || tones.sizing.are_strokes) return;
    const Field& all = tones.all();
    const double most = kMostPixels * domain.width / all.columns;
    const std::vector<double> widths = widths_of({all, domain}, most);
    std::vector<std::vector<double>> shares(tones.fields.size());
    for (std::size_t k = 0; k < shares.size(); ++k) {
        const std::uint64_t its_dots = tones.has_inks() ? tones.layers[k].dots : dots;
        shares[k].assign(widths.size(), 1);
        if (tones.sizing_of(k).pens || its_dots == 0) continue;
        // Dots elsewhere are the wider, the more dots narrow shapes have. So their width is found
        // step by step.
        for (int step = 0; step < kSteps; ++step) {
            Sizing sizing = tones.sizing_of(k);
            sizing.shares = shares[k];
            const double ink = darkness_of(density_of(tones.fields[k], sizing)) * domain.width *
                               domain.height / static_cast<double>(its_dots);
            const double diameter = std::sqrt(4 / std::numbers::pi * ink);
            for_each_polled(widths.size(), ask, [&](std::size_t i) {
                const double part = widths[i] / diameter;
                const bool is_narrow = widths[i] < most && part < 1;
                shares[k][i] = is_narrow ? std::max(part * part, kLeastShare) : 1;
            });
        }
    }
    tones.shares = std::move(shares);
    tones.varied.clear();
    for (std::size_t k = 0; k < tones.fields.size(); ++k)
        tones.varied.push_back(density_of(tones.fields[k], tones.sizing_of(k)));
}

std::vector<InkPart> parts_of(const Tones& tones) {
    std::vector<InkPart> parts;
    for (std::size_t k = 0; k < tones.layers.size(); ++k)
        if (tones.layers[k].dots != 0)
            parts.push_back({&tones.densities()[k], tones.layers[k].dots});
    return parts;
}

std::vector<double> diameters_of(const Tones& tones, const files::PointSet& set,
                                 const drawing::Style& style) {
    std::vector<double> diameters = toned_diameters(tones, set, style);
    if (!tones.keep_inside) return diameters;
    const double scale = millimetres_per_unit(set, style);
    std::size_t first = 0;
    for (std::size_t k = 0; k < tones.fields.size(); ++k) {
        const std::size_t count = tones.has_inks() ? tones.layers[k].dots : set.points.size();
        const auto its_dots = set.points.subspan(first, count);
        const auto its_diameters = std::span(diameters).subspan(first, count);
        first += count;
        // A pen draws no dot that is smaller than it, and each of several pens has its own size.
        const std::optional<Pens> pens = tones.sizing_of(k).pens;
        if (pens && !pens->widths_mm.empty()) continue;
        fit_inside(its_dots, its_diameters, {tones.all(), set.domain},
                   pens ? pens->least_mm / scale : 0);
    }
    return diameters;
}

void pull_inside(const Tones& tones, const files::PointSet& set, const drawing::Style& style,
                 std::span<Point> points) {
    if (tones.keep_inside)
        pull_inside(points, toned_diameters(tones, set, style), {tones.all(), set.domain});
}

}  // namespace lacuna::stippling
