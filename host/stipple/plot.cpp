// Measures the way of a pen.
#include "stipple/plot.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "base/polling.h"
#include "drawing/page.h"
#include "stipple/pen/plotting_time.h"
#include "stipple/strokes.h"

namespace lacuna::stippling {
namespace {

// The way of the pen through a layer, in the domain's unit.
class Way {
public:
    Way(const Stippling& made, std::span<const Point> dots, std::span<const double> diameters,
        double mm_per_unit)
        : made_(made), dots_(dots), diameters_(diameters), mm_(mm_per_unit) {}

    // How far it goes from the dot or stroke before this one. Strokes have one layer.
    double to(std::size_t i) const {
        if (i == 0) return 0;
        Point from = dots_[i - 1], to = dots_[i];
        if (made_.are_strokes) {
            from = end_of(from, made_.ellipses[i - 1], 1);
            to = end_of(to, made_.ellipses[i], -1);
        }
        from.x += dot(i - 1).end();
        to.x += dot(i).begin();
        return std::hypot(to.x - from.x, to.y - from.y);
    }

    double stroke(std::size_t i) const {
        return made_.are_strokes ? 2 * (made_.ellipses[i].a - made_.ellipses[i].b) : 0;
    }

    drawing::PenDot dot(std::size_t i) const {
        if (made_.pen_mm == 0) return {};
        return drawing::pen_dot(diameters_[i], made_.pen_mm / mm_, made_.circles);
    }

private:
    const Stippling& made_;
    std::span<const Point> dots_;
    std::span<const double> diameters_;
    double mm_;
};

}  // namespace

void plot(Stippling& made, const files::PointSet& dots, const Plotter& plotter,
          double mm_per_unit) {
    drawing::Style style;
    style.diameters = made.diameters;
    made.layer_plots.assign(std::max<std::size_t>(1, dots.layers.size()), {});
    made.path_length = made.plot_seconds = 0;
    drawing::for_each_layer(dots, style, [&](std::size_t k, const auto& part, const auto& own) {
        auto& [length, seconds] = made.layer_plots[k];
        const Way way(made, part.points, own.diameters, mm_per_unit);
        const bool stays_down = made.line_width != 0;
        for (std::size_t i = 0; i < part.points.size(); ++i) {
            ask_after();
            drawing::PenDot dot = way.dot(i);
            const double drawn = way.stroke(i) + dot.length();
            length += way.to(i) + drawn;
            made.admitted_length += drawn;
            if (stays_down) continue;
            dot.step *= mm_per_unit;
            seconds += plotter.seconds_per_dot + pen::seconds_up(plotter, way.to(i) * mm_per_unit) +
                       pen::seconds_straight_down(plotter, way.stroke(i) * mm_per_unit) +
                       pen::seconds_around(plotter, dot);
        }
        if (stays_down)
            seconds =
                plotter.seconds_per_dot + pen::seconds_down(plotter, part.points, mm_per_unit);
        made.path_length += length;
        made.plot_seconds += seconds;
    });
    if (!made.is_for_a_pen) made.admitted_length = made.path_length;
}

}  // namespace lacuna::stippling
