// A frame with axes on a canvas, and curves in it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "drawing/canvas.h"

namespace lacuna::drawing {

struct Axis {
    double from;
    double to;
    std::string label;
    bool is_logarithmic = false;  // all numbers are exponents of 10
};

// About `wanted` numbers between `from` and `to`, spaced by 1, 2 or 5 times a power of ten.
std::vector<double> ticks_of(double from, double to, int wanted);

// Whether there are faint lines at the ticks.
enum class Grid { drawn, none };

// `number` with a leading hyphen replaced by a true minus sign, which is as wide as a digit.
std::string with_minus(const std::string& number);

class Plot {
public:
    // `box` is the frame: labels are outside it.
    Plot(Canvas& canvas, const Rectangle& box, Axis x, Axis y);

    // Draws the frame, ticks, numbers and labels, and a title above.
    void draw_axes(const std::string& title, Grid grid = Grid::drawn);

    // Draws a curve through positions in the axes' units, cut off at the frame.
    void draw_curve(std::span<const Point> curve, const Pen& pen);
    // Draws a dashed line over the whole width. `words`, if any, stand in the upper left corner.
    void draw_level(double y, const std::string& words);

    const Rectangle& box() const { return box_; }

private:
    Position position_of(Point point) const;
    static std::string words_at(const Axis& axis, double value);
    void draw_tick_x(double value, Grid grid);
    void draw_tick_y(double value, Grid grid);

    Canvas& canvas_;
    Rectangle box_;
    Axis x_;
    Axis y_;
};

}  // namespace lacuna::drawing
