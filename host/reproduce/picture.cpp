// Draws the parts of the pictures.
#include "reproduce/picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace lacuna::reproduce {
namespace {

constexpr double kTextSize = 8;

}  // namespace

void draw_legend(Canvas& canvas, const Rectangle& box, std::span<const Key> keys, Anchor corner) {
    constexpr double kLine = 11;
    constexpr double kStroke = 16;
    const bool is_left = corner == Anchor::start;
    double base = box.top + kLine + 2;
    for (const Key& key : keys) {
        const double from = is_left ? box.left + 6 : box.right() - 6 - kStroke;
        const std::array<drawing::Position, 2> stroke{drawing::Position{from, base - 3},
                                                      drawing::Position{from + kStroke, base - 3}};
        canvas.line(stroke, key.pen, box);
        canvas.text({is_left ? from + kStroke + 4 : from - 4, base}, key.words,
                    {kTextSize, is_left ? Anchor::start : Anchor::end, kInk});
        base += kLine;
    }
}

void draw_title(Canvas& canvas, const Rectangle& box, const std::string& title) {
    canvas.text({box.left, box.top - 6}, title, {10, Anchor::start, kInk, true});
}

void draw_periodogram(Canvas& canvas, const Rectangle& box, const analysis::Spectrum& spectrum,
                      double farthest, int block, Turned turned) {
    constexpr double kWhitePower = 3;
    const int reach = static_cast<int>(std::lround(farthest * std::sqrt(spectrum.count)));
    const int k_max = std::min({reach, spectrum.range.kx_max, spectrum.range.ky_max});
    const auto power = [&](int right, int up) {
        return turned == Turned::yes ? spectrum.power(up, right) : spectrum.power(right, up);
    };
    const auto mean = [&](int left, int top) {
        double sum = 0;
        int frequencies = 0;
        for (int up = top; up > top - block && up >= -k_max; --up)
            for (int right = left; right < left + block && right <= k_max; ++right, ++frequencies)
                sum += power(right, up);
        return sum / frequencies;
    };
    const int side = (2 * k_max + block) / block;
    drawing::Image image{side, side, {}};
    for (int up = k_max; up >= -k_max; up -= block)
        for (int right = -k_max; right <= k_max; right += block)
            image.greys.push_back(static_cast<std::uint8_t>(
                std::lround(255 * std::min(1.0, mean(right, up) / kWhitePower))));
    canvas.image(box, image);
    canvas.frame(box, {kInk, 0.6});
}

void draw_radial_power(Canvas& canvas, const Rectangle& box, const std::string& title,
                       const analysis::Radial& radial, Colour colour) {
    Plot plot(canvas, box, {0, 2, "k / \u221aN"}, {0, 2, "power"});
    plot.draw_axes(title);
    plot.draw_level(1, "");
    std::vector<Point> curve;
    for (const analysis::Annulus& annulus : radial.annuli)
        curve.push_back({annulus.frequency, annulus.power});
    plot.draw_curve(curve, {colour, 1});
}

void draw_anisotropy(Canvas& canvas, const Rectangle& box, const std::string& title,
                     const analysis::Analysis& analysis, Colour colour) {
    Plot plot(canvas, box, {0, 2, "k / \u221aN"}, {-20, 10, "dB"});
    plot.draw_axes(title);
    plot.draw_level(-10 * std::log10(static_cast<double>(analysis.sets)), "");
    std::vector<Point> curve;
    for (const analysis::Annulus& annulus : analysis.radial.annuli)
        if (annulus.anisotropy_db) curve.push_back({annulus.frequency, *annulus.anisotropy_db});
    plot.draw_curve(curve, {colour, 1});
}

void draw_field(Canvas& canvas, const Rectangle& box, const Field& field) {
    const double most = *std::max_element(field.importance.begin(), field.importance.end());
    drawing::Image image{static_cast<int>(field.columns), static_cast<int>(field.rows), {}};
    for (const double importance : field.importance)
        image.greys.push_back(
            static_cast<std::uint8_t>(std::lround(255 * (1 - importance / most))));
    canvas.image(box, image);
    canvas.frame(box, {kInk, 0.6});
}

void draw_dots(Canvas& canvas, const Rectangle& box, std::span<const Point> points, double width,
               double height, double radius) {
    std::vector<drawing::Position> positions;
    positions.reserve(points.size());
    for (const Point& point : points)
        positions.push_back(
            {box.left + point.x / width * box.width, box.bottom() - point.y / height * box.height});
    canvas.dots(positions, radius / width * box.width, box);
    canvas.frame(box, {kInk, 0.6});
}

analysis::Analysis analyse_on_torus(std::span<const std::vector<Point>> sets, double radius,
                                    Work& work) {
    const std::vector<std::optional<double>> radii(sets.size(), radius);
    return analysis::analyse(sets, {1, 1, true}, radii, [&](double) { return work.keep_going(); });
}

nlohmann::ordered_json json_of(const analysis::Analysis& analysis, double farthest) {
    nlohmann::ordered_json frequencies;
    nlohmann::ordered_json powers;
    nlohmann::ordered_json anisotropies;
    for (const analysis::Annulus& annulus : analysis.radial.annuli) {
        if (annulus.frequency > farthest) break;
        frequencies.push_back(annulus.frequency);
        powers.push_back(annulus.power);
        anisotropies.push_back(annulus.anisotropy_db
                                   ? nlohmann::ordered_json(*annulus.anisotropy_db)
                                   : nlohmann::ordered_json(nullptr));
    }
    return {{"sets", analysis.sets},
            {"mean_count", analysis.counts.mean},
            {"k_over_sqrt_count", std::move(frequencies)},
            {"mean_power", std::move(powers)},
            {"anisotropy_db", std::move(anisotropies)},
            {"power_on_line_kx_0_over_rest", analysis.vertical_line->ratio},
            {"power_on_line_ky_0_over_rest", analysis.horizontal_line->ratio}};
}

}  // namespace lacuna::reproduce
