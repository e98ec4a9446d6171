// The model is that of AxiDraw's software: the pen goes at full speed or accelerates, and before a
// corner it slows down as much as its angle asks for. docs/stipple_measured.md has its numbers.
#include "stipple/pen/plotting_time.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

#include "base/polling.h"

namespace lacuna::pen {
namespace {

constexpr double kMillimetresPerMetre = 1000;
// With the pen up it accelerates this many times as fast.
constexpr double kFasterUp = 1.5;
// The speed in a corner is that on an arc which leaves the corner by this much, in mm, and on which
// the pen is accelerated sideways as much as it may be along its way.
constexpr double kCornering = 0.05;

struct Motion {
    double per_mm;         // the time for a millimetre at full speed
    double less_per_mm_s;  // the inverse of the acceleration, in s^2 / mm

    double from_stop_to_stop(double mm) const {
        if (less_per_mm_s == 0) return mm * per_mm;
        const bool gets_to_full_speed = mm * per_mm * per_mm >= less_per_mm_s;
        return gets_to_full_speed ? mm * per_mm + less_per_mm_s / per_mm
                                  : 2 * std::sqrt(mm * less_per_mm_s);
    }
};

// Stopping and starting again costs full speed over acceleration.
Motion with_pen_down(const Plotter& plotter) {
    const double per_mm = plotter.seconds_per_metre_down / kMillimetresPerMetre;
    return {per_mm, per_mm * plotter.seconds_per_corner};
}

// Segments of a line, and what is between each and the next: the cosine of half of the angle by
// which the line turns there.
struct Segments {
    std::vector<double> mm;
    std::vector<double> cosines;
};

double seconds_for(const Motion& motion, const Segments& line) {
    const auto& [mm, cosines] = line;
    if (motion.less_per_mm_s == 0)
        return motion.per_mm * std::accumulate(mm.begin(), mm.end(), 0.0);
    const double acceleration = 1 / motion.less_per_mm_s;
    const double full = 1 / (motion.per_mm * motion.per_mm);
    std::vector<double> squares(mm.size() + 1);  // of the speeds at the ends of segments
    for (std::size_t i = 0; i < mm.size(); ++i) {
        const double next = squares[i] + 2 * acceleration * mm[i];
        if (i + 1 < mm.size())
            squares[i + 1] =
                std::min({full, acceleration * kCornering * cosines[i] / (1 - cosines[i]), next});
    }
    double seconds = 0;
    for (std::size_t i = mm.size(); i-- > 0;) {
        squares[i] = std::min(squares[i], squares[i + 1] + 2 * acceleration * mm[i]);
        const double both = squares[i] + squares[i + 1];
        const double most = std::min(full, both / 2 + acceleration * mm[i]);
        const double changes =
            2 * std::sqrt(most) - std::sqrt(squares[i]) - std::sqrt(squares[i + 1]);
        const double steady = mm[i] - (2 * most - both) * motion.less_per_mm_s / 2;
        seconds += changes * motion.less_per_mm_s + std::max(0.0, steady) * motion.per_mm;
    }
    return seconds;
}

}  // namespace

double seconds_up(const Plotter& plotter, double mm) {
    return Motion{plotter.seconds_per_metre_up / kMillimetresPerMetre,
                  with_pen_down(plotter).less_per_mm_s / kFasterUp}
        .from_stop_to_stop(mm);
}

double seconds_straight_down(const Plotter& plotter, double mm) {
    return with_pen_down(plotter).from_stop_to_stop(mm);
}

double seconds_around(const Plotter& plotter, const drawing::PenDot& dot) {
    const Motion motion = with_pen_down(plotter);
    double seconds = 0, per_mm = 0;
    dot.for_each_half([&](double, double radius, bool) {
        per_mm = std::max(motion.per_mm, std::sqrt(motion.less_per_mm_s / radius));
        seconds += std::numbers::pi * radius * per_mm;
    });
    return per_mm == 0 ? 0 : seconds + motion.less_per_mm_s / per_mm;
}

double seconds_down(const Plotter& plotter, std::span<const Point> line, double mm_per_unit) {
    Segments segments;
    ask_after(8 * line.size());
    Point before{};  // of length 1
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double x = line[i].x - line[i - 1].x, y = line[i].y - line[i - 1].y;
        const double length = std::sqrt(x * x + y * y);
        if (length == 0) continue;
        const Point way{x / length, y / length};
        const double cosine = std::clamp(way.x * before.x + way.y * before.y, -1.0, 1.0);
        if (!segments.mm.empty()) segments.cosines.push_back(std::sqrt((1 + cosine) / 2));
        segments.mm.push_back(length * mm_per_unit);
        before = way;
    }
    return seconds_for(with_pen_down(plotter), segments);
}

double usual_seconds_down(const Plotter& plotter, double mm) {
    // For turns by 10, 116, 42, 76, 54, 92, 28 and 64 degrees. Each is about as frequent as the
    // others in lines through the dots of photographs.
    constexpr std::array kCosines{0.9962, 0.5299, 0.9336, 0.7880, 0.8910, 0.6947, 0.9703, 0.8480};
    constexpr std::size_t kSegments = 160;
    Segments segments{std::vector<double>(kSegments, mm), {}};
    for (std::size_t i = 1; i < kSegments; ++i)
        segments.cosines.push_back(kCosines[i % kCosines.size()]);
    return seconds_for(with_pen_down(plotter), segments) / kSegments;
}

}  // namespace lacuna::pen
