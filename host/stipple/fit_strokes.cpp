// Compares what strokes cover near each of them with what they are to cover.
#include "stipple/fit_strokes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "stipple/coverage.h"

namespace lacuna::stippling {
namespace {

// A rectangle of positions: from `left` to before `right`, and so on.
struct Window {
    std::size_t left;
    std::size_t right;
    std::size_t low;
    std::size_t high;
};

// The positions of a raster that are no further from (x, y) than `reach` across and up.
Window window_around(double x, double y, double reach, const Raster& raster) {
    const auto limits = [&](double at, std::size_t end) {
        const auto within = [&](double place) {
            return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(end)));
        };
        return std::pair(within(std::floor(at - reach)), within(std::ceil(at + reach)));
    };
    const auto [left, right] = limits(x, raster.columns());
    const auto [low, high] = limits(y, raster.rows());
    return {left, right, low, high};
}

// The means of a value in windows of a raster, from running sums in both directions.
class Means {
public:
    explicit Means(const Raster& raster)
        : width_(raster.columns() + 1), sums_(width_ * (raster.rows() + 1)) {}

    // Has value(column, row) for every position.
    template <typename Value>
    void fill(Value value) {
        for (std::size_t i = width_; i < sums_.size(); i += width_) {
            ask_after(width_);
            double sum = 0;
            for (std::size_t column = 0; column + 1 < width_; ++column) {
                sum += value(column, i / width_ - 1);
                sums_[i + column + 1] = sums_[i - width_ + column + 1] + sum;
            }
        }
    }

    double of(const Window& window) const {
        const auto& [left, right, low, high] = window;
        const auto below = [&](std::size_t x, std::size_t y) { return sums_[y * width_ + x]; };
        return (below(right, high) - below(left, high) - below(right, low) + below(left, low)) /
               static_cast<double>((right - left) * (high - low));
    }

private:
    std::size_t width_;
    std::vector<double> sums_;  // of all positions below and to the left
};

// By how much a stroke is to be longer. Where most is covered already, more ink covers less. Half
// of the way, because its neighbours change, too.
double factor_for(double wanted, double covered) {
    constexpr double kMost = 0.99, kLargest = 1.4;
    wanted = std::min(wanted, kMost);
    covered = std::min(covered, kMost);
    if (covered <= 0) return kLargest;
    const double way = wanted / covered * std::sqrt((1 - covered) / (1 - wanted));
    return std::clamp(std::sqrt(way), 1 / kLargest, kLargest);
}

}  // namespace

void fit_strokes(std::span<const Point> middles, std::span<Ellipse> strokes,
                 std::span<const double> reaches, const Field& field, const Domain& domain) {
    constexpr int kRounds = 4;
    constexpr double kReach = 2;      // of a window, in distances to a stroke's neighbours
    constexpr double kLongest = 1.5;  // times as long as before: few strokes cannot show everything
    constexpr double kLeast = 1 << 16, kMost = 1 << 22, kForAStroke = 64;
    Raster raster(domain,
                  std::clamp(kForAStroke * static_cast<double>(strokes.size()), kLeast, kMost));
    const std::size_t columns = raster.columns(), rows = raster.rows();
    Means wanted(raster), covered(raster);
    wanted.fill([&](std::size_t column, std::size_t row) {
        const std::size_t from_top = rows - 1 - row;
        return field.importance[(2 * from_top + 1) * field.rows / (2 * rows) * field.columns +
                                (2 * column + 1) * field.columns / (2 * columns)];
    });
    const double per_x = static_cast<double>(columns) / domain.width;
    const double per_y = static_cast<double>(rows) / domain.height;
    std::vector<double> longest;
    for (const Ellipse& one : strokes) longest.push_back(kLongest * one.a);
    for (int round = 0; round < kRounds; ++round) {
        raster.clear();
        for (std::size_t i = 0; i < strokes.size(); ++i)
            raster.cover_stroke(middles[i], strokes[i]);
        covered.fill([&](std::size_t column, std::size_t row) {
            return raster.covered()[row * columns + column];
        });
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            const Point at = domain.from_corner(middles[i]);
            const Window window =
                window_around(at.x * per_x, at.y * per_y, kReach * reaches[i] * per_x, raster);
            const double factor = factor_for(wanted.of(window), covered.of(window));
            strokes[i].a = std::clamp(factor * strokes[i].a, strokes[i].b, longest[i]);
        }
    }
}

}  // namespace lacuna::stippling
