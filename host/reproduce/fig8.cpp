// Figure 8: the benefits of maximality and of the min-conflict metric. 20,000 dots each.
//
// (a) min; (b) max; (c) min with radii for about 22,000 dots, of which the first 20,000 are kept,
// so that the set is not maximal. The paper's image is not free, so shapes.h is used with contrast
// 50 : 1. The quality of a set is tone_error (stipple.h) with 32 squares across.
#include <fmt/core.h>

#include <array>
#include <limits>
#include <utility>

#include "reproduce/picture.h"
#include "reproduce/reproduce.h"
#include "reproduce/shapes.h"
#include "reproduce/stipple.h"

namespace lacuna::reproduce {
namespace {

constexpr double kBackground = 0.02;
constexpr std::uint64_t kMoreDots = 22'000;
constexpr std::uint32_t kAcross = 32;

struct Version {
    std::string name;
    std::vector<Point> dots;
    double error;
};

Version make(const Field& field, std::string name, std::uint64_t dots, Metric metric, Work& work) {
    std::vector<Point> points = std::move(stipple(field, dots, metric, work, 1).points[0]);
    points.resize(kDots);  // any prefix of a set is unbiased
    const double error = tone_error(field, points, kAcross);
    return {std::move(name), std::move(points), error};
}

// Draws the four bars of the field, enlarged.
std::string draw(std::span<const Version> versions, files::Medium medium) {
    constexpr Rectangle kPart{0.3, 0.06, 0.5, 0.36};  // of the unit square, y upwards
    constexpr double kWidth = 250;
    constexpr double kHeight = kWidth * kPart.height / kPart.width;
    const auto canvas = drawing::make_canvas(medium, 3 * (kWidth + 10) + 10, kHeight + 34);
    double left = 10;
    for (const Version& version : versions) {
        std::vector<Point> part;
        for (const Point& dot : version.dots)
            part.push_back({dot.x - kPart.left, dot.y - kPart.top});
        const Rectangle box{left, 24, kWidth, kHeight};
        draw_title(*canvas, box, version.name);
        draw_dots(*canvas, box, part, kPart.width, kPart.height, 0.0012);
        left += kWidth + 10;
    }
    return canvas->finish();
}

}  // namespace

Reproduction fig8(const Setting& setting) {
    const Field field = shapes(kBackground);
    Work work(setting, 3);
    const std::array versions{make(field, "(a) min", kDots, Metric::min, work),
                              make(field, "(b) max", kDots, Metric::max, work),
                              make(field, "(c) min, not maximal", kMoreDots, Metric::min, work)};
    const auto& [a, b, c] = versions;
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    Reproduction made;
    // "max-conflict metric ... produces an image with some cut-outs, even though it is maximal"
    made.numbers = {
        in_words("(b) error over that of (a)", "cut-outs", b.error / a.error, {1, kInfinite}),
        in_words("(c) error over that of (a)", "effect of min", c.error / a.error,
                 {1, b.error / a.error}),
        // "most of the quality improvement is due to use of the min-conflict metric"
        in_words("share of the improvement due to min", "most",
                 (b.error - c.error) / (b.error - a.error), {0.5, 1})};
    for (const Version& version : versions)
        made.data[version.name] = {{"dots", version.dots.size()}, {"tone_error", version.error}};
    made.medium = files::Medium::png;
    made.picture = draw(versions, made.medium);
    return made;
}

}  // namespace lacuna::reproduce
