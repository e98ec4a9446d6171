// Dots of ellipses in an svg.
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

}  // namespace lacuna::drawing
