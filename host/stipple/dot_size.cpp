// Dot sizes at which the ink covers as much paper as the importance asks for.
#include "stipple/dot_size.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "base/polling.h"
#include "base/power.h"
#include "plan/ellipse.h"
#include "stipple/coverage.h"
#include "stipple/dot_count.h"

namespace lacuna::stippling {
namespace {

// The factor by which dots must be wider because they overlap, for importance 0.55, 0.60, ... 1.
// Measured on maximal sets of constant fields in mode cells: m = 10, six sets of 6,600 points,
// coverage at 1500 x 1500 positions. At the last factor 99 % are covered.
constexpr std::array kWider{1.0, 1.002, 1.009, 1.015, 1.025, 1.051, 1.072, 1.110, 1.172, 1.299};
// The same factor for relaxed sets, whose dots overlap less. Measured on the torus: 15 iterations,
// six sets of 6,600 points.
constexpr std::array kWiderRelaxed{1.0, 1.0, 1.0, 1.001, 1.003, 1.007, 1.015, 1.029, 1.058, 1.120};
// The factor at which nothing is left uncovered: in maximal sets it is their radius. In relaxed
// ones 1e-5 of the paper is, measured as above.
constexpr double kSolid = 1.48, kSolidRelaxed = 1.35;
constexpr double kFirst = 0.55, kStep = 0.05;
// The factor by which a line through all dots must be longer because it lies on itself, for the
// same importance, and the same for strokes, which cross. Measured on two photographs, 512 x 600
// and 1024 x 768 pixels on 200 mm, with a pen of 0.3 mm: what the line, or the strokes, cover of
// the pixels of each importance. At the last factor it is 99 %.
constexpr std::array kLonger{1.0, 1.005, 1.01, 1.015, 1.022, 1.03, 1.038, 1.05, 1.075, 1.2};
constexpr std::array kLongerStrokes{1.0, 1.0, 1.008, 1.022, 1.067, 1.12, 1.19, 1.31, 1.505, 2.0};
// Factors and importance are rounded to multiples of this, because few distinct sizes make short
// files.
constexpr double kSizeStep = 0.01;

// The factor of one of these tables for an importance.
double factor_at(double importance, const std::array<double, kWider.size()>& factors) {
    const double place =
        std::clamp((importance - kFirst) / kStep, 0.0, static_cast<double>(factors.size() - 1));
    const std::size_t low = std::min(static_cast<std::size_t>(place), factors.size() - 2);
    return std::lerp(factors[low], factors[low + 1], place - static_cast<double>(low));
}

double wider_at(double importance, Spread spread, bool solid_black) {
    if (solid_black && importance == 1) return spread == Spread::even ? kSolidRelaxed : kSolid;
    const double exact = factor_at(importance, spread == Spread::even ? kWiderRelaxed : kWider);
    return std::round(exact / kSizeStep) * kSizeStep;
}

// The index of the pixel at a coordinate, where `side` is divided into `pixels` pixels.
std::size_t pixel_of(double coordinate, double side, std::uint32_t pixels) {
    const auto place = static_cast<std::int64_t>(coordinate / side * pixels);
    return static_cast<std::size_t>(std::clamp<std::int64_t>(place, 0, pixels - std::int64_t{1}));
}

// The size, over 0, rounded to a power of 2^(1/64), which is 1.1 %.
double in_steps(double size) {
    constexpr std::size_t kSteps = 64;
    static const std::array<double, kSteps + 1> steps = [] {  // from 0.5 to 1
        std::array<double, kSteps + 1> made{};
        for (std::size_t i = 0; i <= kSteps; ++i)
            made[i] = power(0.5, 1 - static_cast<double>(i) / kSteps);
        return made;
    }();
    int exponent = 0;
    const double part = std::frexp(size, &exponent);  // 0.5 <= part < 1
    const auto above = std::upper_bound(steps.begin(), steps.end(), part);
    const auto below = above - 1;
    return std::ldexp(part * part < *below * *above ? *below : *above, exponent);
}

// The factor, 0.8 to 1.25, by which all dots must be wider to cover `area`. Sets that keep least
// distances are less dense than their importance where it is great: their dots overlap less than
// those of kWider. Ellipses overlap more.
double times_for(double area, std::span<const Point> points, std::span<const Ellipse> dots,
                 const Domain& domain) {
    constexpr double kLeast = 0.8, kMost = 1.25;
    constexpr int kSteps = 4;
    constexpr double kNear = 2e-3;  // of the area
    double times = 1, covered = covered_area(points, dots, times, domain);
    // Dots that do not overlap cover as much as their areas; others cover less, so that the slope
    // is measured then.
    double slope = 2 * covered;
    for (int step = 0; step < kSteps && std::abs(covered - area) > kNear * area; ++step) {
        const double next = std::clamp(times + (area - covered) / slope, kLeast, kMost);
        if (next == times) return times;
        const double then = covered_area(points, dots, next, domain);
        if ((then - covered) / (next - times) > 0) slope = (then - covered) / (next - times);
        times = next;
        covered = then;
    }
    return times;
}

}  // namespace

std::size_t index_at(Point point, const Field& field, const Domain& domain) {
    const Point way = domain.from_corner(point);
    const std::size_t row = field.rows - 1 - pixel_of(way.y, domain.height, field.rows);
    return row * field.columns + pixel_of(way.x, domain.width, field.columns);
}

double importance_at(Point point, const Field& field, const Domain& domain) {
    return field.importance[index_at(point, field, domain)];
}

bool Sizing::varies() const {
    return by_tone != 0 || is_line || are_strokes || !shares.empty() ||
           (pens && (fills_overlaps || pens->least_mm != pens->most_mm));
}

double width_at(const Pens& pens, double importance) {
    const double wanted = std::lerp(pens.least_mm, pens.most_mm, importance);
    if (pens.widths_mm.empty()) return wanted;
    return *std::min_element(pens.widths_mm.begin(), pens.widths_mm.end(), [&](double a, double b) {
        return std::abs(a - wanted) < std::abs(b - wanted);
    });
}

double Sizing::layers_at(double importance) const {
    if (!is_line && !are_strokes) return importance;
    return importance * factor_at(importance, is_line ? kLonger : kLongerStrokes);
}

double Sizing::area_at(double importance) const {
    // The line of a wider pen must be as much shorter.
    const double layers = layers_at(importance);
    if (is_line)
        return (pens ? pens->least_mm * pens->least_mm : 1) * importance / (layers * layers);
    if (are_strokes) return importance / layers;
    if (!pens) return by_tone == 0 ? 1 : power(importance, by_tone);
    const double wider = fills_overlaps ? wider_at(importance, spread, false) : 1;
    const double diameter = width_at(*pens, importance) / wider;
    return std::numbers::pi / 4 * diameter * diameter;
}

Field density_of(const Field& field, const Sizing& sizing) {
    Field density = field;
    for_each_polled(density.importance.size(), ask, [&](std::size_t i) {
        double& one = density.importance[i];
        if (one > 0) one /= sizing.area_at(one);
        if (!sizing.shares.empty()) one /= sizing.shares[i];
        if (sizing.are_strokes) one /= std::sqrt(field.stretches[i].ratio);
    });
    return density;
}

std::vector<double> dot_diameters(std::span<const Point> points, const Field& field,
                                  const Domain& domain, Spread spread, const Sizing& sizing) {
    const double mean =
        sizing.varies() ? darkness_of(density_of(field, sizing)) : darkness_of(field);
    const double area = mean * domain.width * domain.height / static_cast<double>(points.size());
    const double diameter = std::sqrt(4 / std::numbers::pi * area);
    std::vector<double> diameters;
    diameters.reserve(points.size());
    const bool suits_area = spread == Spread::random && !sizing.solid_black;
    std::vector<Ellipse> dots;
    for (const Point& point : points) {
        ask_after(4);
        const std::size_t index = index_at(point, field, domain);
        const double importance = field.importance[index];
        const double share = sizing.shares.empty() ? 1 : sizing.shares[index];
        const double size =
            sizing.varies() ? in_steps(std::sqrt(sizing.area_at(importance) * share)) : 1;
        diameters.push_back(diameter * size * wider_at(importance, spread, sizing.solid_black));
        if (suits_area)
            dots.push_back(stretched(diameters.back() / 2,
                                     field.stretches.empty() ? Stretch{} : field.stretches[index]));
    }
    if (!suits_area) return diameters;
    const double times =
        times_for(darkness_of(field) * domain.width * domain.height, points, dots, domain);
    for (double& one : diameters) one *= times;
    return diameters;
}

std::vector<double> pen_diameters(std::span<const Point> points, const Field& field,
                                  const Domain& domain, const Pens& pens,
                                  double millimetres_per_unit) {
    std::vector<double> diameters;
    diameters.reserve(points.size());
    for (const Point& point : points) {
        ask_after(4);
        const double importance = importance_at(point, field, domain);
        // Few distinct sizes make short files.
        const double part =
            pens.widths_mm.empty() ? std::round(importance / kSizeStep) * kSizeStep : importance;
        diameters.push_back(width_at(pens, part) / millimetres_per_unit);
    }
    return diameters;
}

}  // namespace lacuna::stippling
