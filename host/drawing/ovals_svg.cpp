// Dots of ellipses in an svg, strokes, and dots that are wider than their pen.
#include <fmt/compile.h>
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <string>

#include "base/polling.h"
#include "drawing/page.h"
#include "drawing/picture_svg.h"

namespace lacuna::drawing {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;  // in a radian
constexpr double kShortest = 0.01;  // a line of length 0 is not drawn by all programs

}  // namespace

void append_ovals(std::string& bytes, const files::PointSet& set, const Style& style,
                  const Page& page) {
    std::size_t dots = 0;
    const auto end_path = [&] { bytes += dots == 0 ? "" : "\"/>\n"; };
    for_each_oval(set, style, page, [&](const Oval& oval) {
        if (dots % kDotsPerStroke == 0) {
            end_path();
            bytes += "<path fill=\"black\" stroke=\"none\" d=\"";
        }
        ++dots;
        ask_after(32);
        const double x = oval.a * std::cos(oval.turn), y = 0.0 - oval.a * std::sin(oval.turn);
        const std::string arc =
            fmt::format("a{:.5g} {:.5g} {:.5g} 1 0 ", oval.a, oval.b, 0.0 - oval.turn * kDegrees);
        fmt::format_to(std::back_inserter(bytes),
                       FMT_COMPILE("M{:.4f} {:.4f}{}{:.4f} {:.4f}{}{:.4f} {:.4f}\n"), oval.x - x,
                       oval.y - y, arc, 2 * x, 2 * y, arc, -2 * x, -2 * y);
    });
    end_path();
}

void append_strokes(std::string& bytes, const files::PointSet& set, const Page& page) {
    std::size_t dots = 0;
    const auto end_path = [&] { bytes += dots == 0 ? "" : "\"/>\n"; };
    for_each_pen_stroke(set, page, [&](const PenStroke& stroke) {
        if (dots % kDotsPerStroke == 0) {
            end_path();
            bytes += fmt::format("<path stroke-width=\"{:.6g}\" d=\"", stroke.width);
        }
        ++dots;
        ask_after(16);
        const bool is_dot = std::hypot(stroke.way_x, stroke.way_y) < kShortest;
        fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("M{:.4f} {:.4f}l{:.4f} {:.4f}\n"),
                       stroke.x, stroke.y, is_dot ? kShortest : stroke.way_x,
                       is_dot ? 0.0 : stroke.way_y);
    });
    end_path();
}

void append_pen_dots(std::string& bytes, const files::PointSet& set, const Style& style,
                     const Page& page) {
    std::size_t dots = 0;
    const auto end_path = [&] { bytes += dots == 0 ? "" : "\"/>\n"; };
    for_each_pen_dot(set, style, page, [&](double x, double y, const PenDot& dot, double width) {
        if (dots % kDotsPerStroke == 0) {
            end_path();
            bytes += fmt::format("<path stroke-width=\"{:.6g}\" d=\"", width);
        }
        ++dots;
        ask_after(16 * (1 + static_cast<std::size_t>(dot.halves)));
        bytes += fmt::format("M{:.4f} {:.4f}", x + dot.begin(), y);
        if (dot.halves == 0) bytes += fmt::format("h{:.3g}", kShortest);
        dot.for_each_half([&](double, double radius, bool is_above) {
            const double way = is_above ? -2 * radius : 2 * radius;
            bytes += fmt::format("a{0:.4f} {0:.4f} 0 0 0 {1:.4f} 0", radius, way);
        });
        bytes += '\n';
    });
    end_path();
}

}  // namespace lacuna::drawing
