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
};

// Round numbers (1, 2 or 5 times a power of ten apart) from `from` to `to`, about `wanted` of them.
std::vector<double> ticks_of(double from, double to, int wanted);

// Faint lines at the ticks.
enum class Grid { drawn, none };

// With a true minus, as wide as a digit, in place of a leading hyphen.
std::string with_minus(const std::string& number);

class Plot {
public:
    // `box` is the frame: labels stand outside of it.
    Plot(Canvas& canvas, const Rectangle& box, Axis x, Axis y);

    // The frame, ticks, their numbers, the labels and a title above.
    void draw_axes(const std::string& title, Grid grid = Grid::drawn);

    // Through positions in the axes' units, cut off at the frame.
    void draw_curve(std::span<const Point> curve, const Pen& pen);
    // Dashed, over the whole width; unless empty, the words stand in the upper left corner.
    void draw_level(double y, const std::string& words);

    const Rectangle& box() const { return box_; }

private:
    Position position_of(Point point) const;
    void draw_tick_x(double value, Grid grid);
    void draw_tick_y(double value, Grid grid);

    Canvas& canvas_;
    Rectangle box_;
    Axis x_;
    Axis y_;
};

}  // namespace lacuna::drawing
