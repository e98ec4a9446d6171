// Reads the output of sample_bench --benchmark_out=FILE, draws time against the count of points on
// log axes with a curve for each case, and prints each curve's exponent from 10^4 to 10^7 points.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "drawing/canvas.h"
#include "files/point_files.h"

namespace {

using namespace lacuna;
using drawing::Canvas;
using drawing::Rectangle;

struct Measurement {
    double points;
    double seconds;
};
using Curves = std::map<std::string, std::vector<Measurement>>;

// exact/cpu/r=0.001/threads=2/real_time is a point of the curve exact/cpu/threads=2.
std::string curve_of(const std::string& name) {
    return std::regex_replace(name, std::regex("/(r=|N=)[^/]*|/iterations:[^/]*|/real_time"), "");
}

Curves read(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path + ": cannot be read");
    const std::map<std::string, double> units = {{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}};
    Curves curves;
    const auto all = nlohmann::json::parse(file);
    for (const auto& run : all.at("benchmarks")) {
        if (run.value("error_occurred", false) || !run.contains("points")) continue;
        const double unit = units.at(run.at("time_unit").get<std::string>());
        curves[curve_of(run.at("name"))].push_back(
            {run.at("points"), unit * run.at("real_time").get<double>()});
    }
    for (auto& [name, curve] : curves)
        std::sort(curve.begin(), curve.end(),
                  [](const auto& a, const auto& b) { return a.points < b.points; });
    return curves;
}

// Least squares through the logarithms; none for fewer than two counts.
std::optional<double> exponent_of(const std::vector<Measurement>& curve) {
    double n = 0;
    double x = 0;
    double y = 0;
    double xx = 0;
    double xy = 0;
    for (const Measurement& m : curve) {
        if (m.points < 1e4 || m.points > 1e7) continue;
        const double log_points = std::log10(m.points);
        const double log_seconds = std::log10(m.seconds);
        n += 1;
        x += log_points;
        y += log_seconds;
        xx += log_points * log_points;
        xy += log_points * log_seconds;
    }
    const double spread = n * xx - x * x;
    if (n < 2 || spread < 1e-9) return std::nullopt;
    return (n * xy - x * y) / spread;
}

std::string power_of_ten(int exponent) {
    static constexpr std::array<const char*, 10> kDigits{"⁰", "¹", "²", "³", "⁴",
                                                         "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::abs(exponent)))
        text += kDigits.at(static_cast<std::size_t>(digit - '0'));
    return text;
}

class Chart {
public:
    explicit Chart(const Curves& curves) : curves_(curves) {
        double least_points = 1e300, most_points = 0, least_seconds = 1e300, most_seconds = 0;
        for (const auto& [name, curve] : curves)
            for (const Measurement& m : curve) {
                least_points = std::min(least_points, m.points);
                most_points = std::max(most_points, m.points);
                least_seconds = std::min(least_seconds, m.seconds);
                most_seconds = std::max(most_seconds, m.seconds);
            }
        from_x_ = static_cast<int>(std::floor(std::log10(least_points)));
        to_x_ = static_cast<int>(std::ceil(std::log10(most_points)));
        from_y_ = static_cast<int>(std::floor(std::log10(least_seconds)));
        to_y_ = static_cast<int>(std::ceil(std::log10(most_seconds)));
    }

    std::string draw(files::Medium medium) {
        const double height = std::max(440.0, 60.0 + 16.0 * static_cast<double>(curves_.size()));
        const auto canvas = drawing::make_canvas(medium, 860, height);
        draw_axes(*canvas);
        std::size_t i = 0;
        for (const auto& [name, curve] : curves_) draw_curve(*canvas, name, curve, i++);
        return canvas->finish();
    }

private:
    drawing::Position at(double log_points, double log_seconds) const {
        return {box_.left + (log_points - from_x_) / (to_x_ - from_x_) * box_.width,
                box_.bottom() - (log_seconds - from_y_) / (to_y_ - from_y_) * box_.height};
    }

    void draw_axes(Canvas& canvas) const {
        const drawing::Pen grid{{225, 225, 225}, 0.75};
        for (int x = from_x_; x <= to_x_; ++x) {
            canvas.line(std::array{at(x, from_y_), at(x, to_y_)}, grid, box_);
            const auto below = at(x, from_y_);
            canvas.text({below.x, below.y + 16}, power_of_ten(x), {11, drawing::Anchor::middle});
        }
        for (int y = from_y_; y <= to_y_; ++y) {
            canvas.line(std::array{at(from_x_, y), at(to_x_, y)}, grid, box_);
            const auto left = at(from_x_, y);
            canvas.text({left.x - 6, left.y + 4}, power_of_ten(y), {11, drawing::Anchor::end});
        }
        canvas.frame(box_, {{0, 0, 0}, 1});
        canvas.text({box_.left + box_.width / 2, box_.bottom() + 34}, "points",
                    {12, drawing::Anchor::middle});
        canvas.text({18, box_.top + box_.height / 2}, "seconds a set",
                    {12, drawing::Anchor::middle, {0, 0, 0}, false, true});
    }

    void draw_curve(Canvas& canvas, const std::string& name, const std::vector<Measurement>& curve,
                    std::size_t number) const {
        // When colours are used for the second time, curves are dashed; for the third time, thick.
        constexpr std::array kColours{Colour{0, 0, 0}, drawing::kBlue,   drawing::kVermilion,
                                      drawing::kGreen, drawing::kPurple, drawing::kSky,
                                      drawing::kOrange};
        const std::size_t round = number / kColours.size();
        const drawing::Pen pen{kColours[number % kColours.size()], round < 2 ? 1.5 : 3, round == 1};
        std::vector<drawing::Position> line;
        for (const Measurement& m : curve)
            line.push_back(at(std::log10(m.points), std::log10(m.seconds)));
        canvas.line(line, pen, box_);
        canvas.dots(line, 2, box_);
        const double y = box_.top + 8 + 16 * static_cast<double>(number);
        const double x = box_.right() + 14;
        canvas.line(std::array<drawing::Position, 2>{{{x, y}, {x + 22, y}}}, pen,
                    {x, y - 4, 22, 8});
        const auto exponent = exponent_of(curve);
        canvas.text({x + 28, y + 4}, exponent ? fmt::format("{}: N^{:.3f}", name, *exponent) : name,
                    {10});
    }

    const Curves& curves_;
    Rectangle box_{64, 20, 480, 364};
    int from_x_, to_x_, from_y_, to_y_;
};

int run(const std::string& measurements, const std::string& picture) {
    const Curves curves = read(measurements);
    if (curves.empty()) throw std::runtime_error(measurements + ": holds no measurements");
    for (const auto& [name, curve] : curves) {
        const auto exponent = exponent_of(curve);
        std::fputs(fmt::format("{:<36} {} sets, {:.0f} to {:.0f} points, exponent {}\n", name,
                               curve.size(), curve.front().points, curve.back().points,
                               exponent ? fmt::format("{:.3f}", *exponent) : "-")
                       .c_str(),
                   stdout);
    }
    files::write_whole(picture, Chart(curves).draw(*files::format_of(picture).medium));
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("usage: speed_plot MEASUREMENTS.json PICTURE.svg|pdf|png\n", stderr);
        return 2;
    }
    try {
        return run(argv[1], argv[2]);
    } catch (const std::exception& error) {
        std::fputs(fmt::format("speed_plot: {}\n", error.what()).c_str(), stderr);
        return 1;
    }
}
