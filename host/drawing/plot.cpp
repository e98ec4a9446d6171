// Draws axes and curves.
#include "drawing/plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lacuna::drawing {
namespace {

constexpr Colour kInk{0x22, 0x22, 0x22};
constexpr Colour kFaint{0xe4, 0xe4, 0xe4};
constexpr Colour kReference{0xa0, 0x30, 0x30};
constexpr double kTitleSize = 10;
constexpr double kTextSize = 8;
constexpr double kTick = 3;

std::string words_of(double value) {
    return with_minus(fmt::format("{:.6g}", value));
}

}  // namespace

std::vector<double> ticks_of(double from, double to, int wanted) {
    const double rough = (to - from) / wanted;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    double step = 10 * power;
    for (const double factor : {5.0, 2.0, 1.0})
        if (factor * power >= rough) step = factor * power;
    std::vector<double> ticks;
    constexpr double kRounding = 1e-9;
    for (double i = std::ceil(from / step - kRounding); i * step <= to + kRounding * step; ++i)
        ticks.push_back(i * step + 0.0);  // + 0.0 turns -0 into 0
    return ticks;
}

std::string with_minus(const std::string& number) {
    return number.starts_with('-') ? "\u2212" + number.substr(1) : number;
}

Plot::Plot(Canvas& canvas, const Rectangle& box, Axis x, Axis y)
    : canvas_(canvas), box_(box), x_(std::move(x)), y_(std::move(y)) {}

Position Plot::position_of(Point point) const {
    return {box_.left + (point.x - x_.from) / (x_.to - x_.from) * box_.width,
            box_.bottom() - (point.y - y_.from) / (y_.to - y_.from) * box_.height};
}

std::string Plot::words_at(const Axis& axis, double value) {
    return axis.is_logarithmic ? "1e" + words_of(value) : words_of(value);
}

void Plot::draw_tick_x(double value, Grid grid) {
    const double x = position_of({value, y_.from}).x;
    if (grid == Grid::drawn)
        canvas_.line(std::array<Position, 2>{Position{x, box_.top}, Position{x, box_.bottom()}},
                     {kFaint, 0.5}, box_);
    const Rectangle below{box_.left - 1, box_.bottom(), box_.width + 2, kTick};
    canvas_.line(std::array<Position, 2>{Position{x, below.top}, Position{x, below.bottom()}},
                 {kInk, 0.6}, below);
    canvas_.text({x, below.bottom() + kTextSize}, words_at(x_, value),
                 {kTextSize, Anchor::middle, kInk});
}

void Plot::draw_tick_y(double value, Grid grid) {
    const double y = position_of({x_.from, value}).y;
    if (grid == Grid::drawn)
        canvas_.line(std::array<Position, 2>{Position{box_.left, y}, Position{box_.right(), y}},
                     {kFaint, 0.5}, box_);
    const Rectangle beside{box_.left - kTick, box_.top - 1, kTick, box_.height + 2};
    canvas_.line(std::array<Position, 2>{Position{beside.left, y}, Position{beside.right(), y}},
                 {kInk, 0.6}, beside);
    canvas_.text({beside.left - 2, y + 0.35 * kTextSize}, words_at(y_, value),
                 {kTextSize, Anchor::end, kInk});
}

void Plot::draw_axes(const std::string& title, Grid grid) {
    constexpr double kPointsPerTick = 40;
    constexpr double kLabelBelow = 24;
    constexpr double kLabelBeside = 30;
    const auto ticks_in = [](const Axis& axis, double length) {
        return ticks_of(axis.from, axis.to, std::max(1, static_cast<int>(length / kPointsPerTick)));
    };
    for (const double tick : ticks_in(x_, box_.width)) draw_tick_x(tick, grid);
    for (const double tick : ticks_in(y_, box_.height)) draw_tick_y(tick, grid);
    canvas_.frame(box_, {kInk, 0.6});
    canvas_.text({box_.left, box_.top - 6}, title, {kTitleSize, Anchor::start, kInk, true});
    canvas_.text({box_.left + box_.width / 2, box_.bottom() + kLabelBelow}, x_.label,
                 {kTextSize, Anchor::middle, kInk});
    canvas_.text({box_.left - kLabelBeside, box_.top + box_.height / 2}, y_.label,
                 {kTextSize, Anchor::middle, kInk, false, true});
}

void Plot::draw_curve(std::span<const Point> curve, const Pen& pen) {
    std::vector<Position> positions;
    positions.reserve(curve.size());
    for (const Point& point : curve) positions.push_back(position_of(point));
    canvas_.line(positions, pen, box_);
}

void Plot::draw_level(double y, const std::string& words) {
    draw_curve(std::array<Point, 2>{Point{x_.from, y}, Point{x_.to, y}}, {kReference, 0.8, true});
    // The words stand in the upper corner, where they hide no curve.
    if (words.empty()) return;
    const double base = box_.top + kTextSize + 4;
    canvas_.line(std::array<Position, 2>{Position{box_.left + 6, base - 3},
                                         Position{box_.left + 24, base - 3}},
                 {kReference, 0.8, true}, box_);
    canvas_.text({box_.left + 28, base}, words, {kTextSize, Anchor::start, kReference});
}

}  // namespace lacuna::drawing
