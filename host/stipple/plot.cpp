// Measures the way of a pen.
#include "stipple/plot.h"

#include <cmath>
#include <cstddef>
#include <span>

#include "drawing/page.h"
#include "stipple/pen/plotting_time.h"
#include "stipple/strokes.h"

namespace lacuna::stippling {
namespace {

// How far the pen goes from the dot or stroke before this one of a layer. Strokes have one layer.
double way_to(std::size_t i, std::span<const Point> dots, const Stippling& made) {
    if (i == 0) return 0;
    Point from = dots[i - 1], to = dots[i];
    if (made.are_strokes) {
        from = end_of(from, made.ellipses[i - 1], 1);
        to = end_of(to, made.ellipses[i], -1);
    }
    return std::hypot(to.x - from.x, to.y - from.y);
}

double stroke_length(std::size_t i, const Stippling& made) {
    return made.are_strokes ? 2 * (made.ellipses[i].a - made.ellipses[i].b) : 0;
}

}  // namespace

void measure_path(Stippling& made, const files::PointSet& dots) {
    double& length = made.path_length;
    drawing::for_each_layer(dots, {}, [&](std::size_t, const auto& part, const auto&) {
        for (std::size_t i = 0; i < part.points.size(); ++i) {
            length += way_to(i, part.points, made) + stroke_length(i, made);
            made.admitted_length += stroke_length(i, made);
        }
    });
    if (!made.is_for_a_pen) made.admitted_length = length;
}

void time_the_plot(Stippling& made, const files::PointSet& dots, const Plotter& plotter,
                   double mm_per_unit) {
    double& seconds = made.plot_seconds;
    drawing::for_each_layer(dots, {}, [&](std::size_t, const auto& part, const auto&) {
        if (made.line_width != 0) {  // the pen stays down
            seconds +=
                plotter.seconds_per_dot + pen::seconds_down(plotter, part.points, mm_per_unit);
            return;
        }
        for (std::size_t i = 0; i < part.points.size(); ++i)
            seconds += plotter.seconds_per_dot +
                       pen::seconds_up(plotter, way_to(i, part.points, made) * mm_per_unit) +
                       pen::seconds_straight_down(plotter, stroke_length(i, made) * mm_per_unit);
    });
}

}  // namespace lacuna::stippling
