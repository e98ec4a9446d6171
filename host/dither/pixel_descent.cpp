// Descent on the error that samples make against the shares of their pixels, seen through
// Gaussians, by moving one sample at a time to a pixel nearby (Analoui & Allebach 1992,
// "Model-based halftoning using direct binary search").
#include "dither/pixel_descent.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "base/polling.h"
#include "base/power.h"

namespace lacuna {
namespace {

constexpr std::int64_t kOne = PixelShares::kOne;

// The deviations of the Gaussians, in pixels. One is as wide as kWide spacings of the samples or,
// where most pixels have one, of the others. Where spacings differ, there are more, each twice as
// wide as the one before.
std::vector<double> deviations_of(const PixelShares& shares, std::span<const std::int32_t> parts) {
    constexpr double kWide = 0.7, kLeast = 1, kMost = 64;
    // Samples, or pixels without one, in 1 / kOne.
    std::vector<std::uint64_t> at_share(kOne / 2 + 1);
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (!shares.is_open(i)) continue;
        const auto minority =
            static_cast<std::size_t>(std::min<std::int64_t>(parts[i], kOne - parts[i]));
        at_share[minority] += minority;
        sum += minority;
    }
    if (sum == 0) return {};
    // The deviation for the share that a tenth, or nine tenths, of the minority have at most.
    const auto deviation = [&](std::uint64_t tenths) {
        std::size_t share = 0;
        for (std::uint64_t below = 0; below * 10 < sum * tenths;) below += at_share[++share];
        const double spacing = std::sqrt(static_cast<double>(kOne) / static_cast<double>(share));
        return std::clamp(kWide * spacing, kLeast, kMost);
    };
    constexpr double kNearly = 1.4;
    const double widest = deviation(1);
    std::vector<double> deviations{deviation(9)};
    while (deviations.back() * kNearly < widest)
        deviations.push_back(std::min(2 * deviations.back(), widest));
    return deviations;
}

class PixelDescent {
public:
    PixelDescent(const Raster& raster, bool wraps, const PixelShares& shares,
                 std::span<const std::int32_t> parts, std::vector<std::uint8_t>& taken,
                 const std::vector<double>& deviations)
        : shares_(shares),
          parts_(parts),
          taken_(taken),
          wraps_(wraps),
          columns_(raster.columns),
          rows_(raster.rows),
          narrowest_(deviations.front()),
          error_(taken.size()) {
        constexpr double kReach = 4;     // in deviations
        constexpr double kScale = 8192;  // times the widest deviation: sums have 29 bits
        constexpr double kEulerInverse = 0.36787944117144233;
        const auto reach = [&](std::int64_t side) {
            const auto far = static_cast<std::int64_t>(std::ceil(kReach * deviations.back()));
            return std::min(far, wraps_ ? (side - 1) / 2 : side - 1);
        };
        reach_x_ = reach(columns_);
        reach_y_ = reach(rows_);
        kernel_.resize(width_of(reach_x_) * width_of(reach_y_));
        const double scale =
            kScale / (deviations.back() * std::sqrt(static_cast<double>(deviations.size())));
        for (const double deviation : deviations) {
            const double unit = power(kEulerInverse, 1 / (2 * deviation * deviation));
            std::vector<double> line;
            for (std::int64_t i = 0; i <= std::max(reach_x_, reach_y_); ++i)
                line.push_back(scale * power(unit, static_cast<double>(i * i)));
            add_gaussian(line);
        }
    }

    // Moves samples until none gains by going to a pixel beside it. The first steps are longer
    // where samples are far apart.
    void run() {
        constexpr double kStepsADeviation = 3;
        std::int64_t step = std::max<std::int64_t>(
            1,
            std::min({static_cast<std::int64_t>(narrowest_ / kStepsADeviation),
                      std::max<std::int64_t>(reach_x_, 1), std::max<std::int64_t>(reach_y_, 1)}));
        for (;; step = std::max<std::int64_t>(1, step / 2)) {
            std::size_t moves = 0;
            for (std::int64_t y = 0; y < rows_; ++y) {
                ask_after(static_cast<std::size_t>(columns_));
                for (std::int64_t x = 0; x < columns_; ++x)
                    if (move(x, y, step)) ++moves;
            }
            if (moves == 0 && step == 1) return;
        }
    }

private:
    static std::size_t width_of(std::int64_t reach) {
        return static_cast<std::size_t>(2 * reach + 1);
    }
    std::size_t pixel(std::int64_t x, std::int64_t y) const {
        return static_cast<std::size_t>(y * columns_ + x);
    }
    // The pixel beyond an edge that wraps; -1 where there is none.
    std::int64_t place(std::int64_t at, std::int64_t side) const {
        if (at >= 0 && at < side) return at;
        return wraps_ ? (at + side) % side : -1;
    }
    std::int32_t kernel(std::int64_t dx, std::int64_t dy) const {
        if (std::abs(dx) > reach_x_ || std::abs(dy) > reach_y_) return 0;
        return kernel_[static_cast<std::size_t>((dy + reach_y_) * (2 * reach_x_ + 1) + dx +
                                                reach_x_)];
    }

    // Adds a Gaussian, whose values along an axis are `line`, to the kernel, and the error of the
    // first samples that is seen through it.
    void add_gaussian(const std::vector<double>& line) {
        std::size_t next = 0;
        for (std::int64_t dy = -reach_y_; dy <= reach_y_; ++dy)
            for (std::int64_t dx = -reach_x_; dx <= reach_x_; ++dx)
                kernel_[next++] += static_cast<std::int32_t>(
                    std::lround(line[static_cast<std::size_t>(std::abs(dy))] *
                                line[static_cast<std::size_t>(std::abs(dx))]));
        constexpr int kDroppedAlongX = 6, kDroppedAlongY = 10;  // bits; together kOne
        std::vector<std::int64_t> weights;
        weights.reserve(line.size());
        for (const double one : line) weights.push_back(std::llround(one));
        std::vector<std::int32_t> seen(error_.size());
        for (std::size_t i = 0; i < seen.size(); ++i)
            seen[i] = static_cast<std::int32_t>(taken_[i] * kOne) - parts_[i];
        seen = summed(seen, weights, reach_x_, 0, kDroppedAlongX);
        seen = summed(seen, weights, 0, reach_y_, kDroppedAlongY);
        for (std::size_t i = 0; i < seen.size(); ++i) error_[i] += seen[i];
    }

    // Weighted sums of pixels along an axis, without their last bits.
    std::vector<std::int32_t> summed(const std::vector<std::int32_t>& from,
                                     const std::vector<std::int64_t>& weights, std::int64_t reach_x,
                                     std::int64_t reach_y, int bits) const {
        std::vector<std::int32_t> result(from.size());
        std::vector<std::int64_t> row(static_cast<std::size_t>(columns_));
        for (std::int64_t y = 0; y < rows_; ++y) {
            ask_after(row.size() * static_cast<std::size_t>(reach_x + reach_y + 1) / 4);
            std::fill(row.begin(), row.end(), 0);
            for (std::int64_t d = -reach_x - reach_y; d <= reach_x + reach_y; ++d) {
                const std::int64_t weight = weights[static_cast<std::size_t>(std::abs(d))];
                const std::int64_t at = reach_x == 0 ? place(y + d, rows_) : y;
                if (at < 0) continue;
                const std::int64_t shift = reach_x == 0 ? 0 : d;
                for (std::int64_t x = 0; x < columns_; ++x)
                    if (const std::int64_t there = place(x + shift, columns_); there >= 0)
                        row[static_cast<std::size_t>(x)] += weight * from[pixel(there, at)];
            }
            for (std::int64_t x = 0; x < columns_; ++x)
                result[pixel(x, y)] =
                    static_cast<std::int32_t>(row[static_cast<std::size_t>(x)] >> bits);
        }
        return result;
    }

    // Adds the kernel around a pixel, or takes it away.
    void add(std::int64_t x, std::int64_t y, std::int32_t sign) {
        const bool is_inner = x >= reach_x_ && x + reach_x_ < columns_;
        const std::int32_t* line = kernel_.data();
        const std::size_t width = width_of(reach_x_);
        for (std::int64_t dy = -reach_y_; dy <= reach_y_; ++dy, line += width) {
            const std::int64_t at = place(y + dy, rows_);
            if (at < 0) continue;
            if (is_inner) {
                std::int32_t* const to = &error_[pixel(x - reach_x_, at)];
                for (std::size_t i = 0; i < width; ++i) to[i] += sign * line[i];
                continue;
            }
            for (std::size_t i = 0; i < width; ++i) {
                const std::int64_t to =
                    place(x - reach_x_ + static_cast<std::int64_t>(i), columns_);
                if (to >= 0) error_[pixel(to, at)] += sign * line[i];
            }
        }
    }

    // Moves the sample of a pixel, if there is one, to the free pixel among eight around it that
    // makes the error least. Of equal ones it is the first. Returns whether it was moved.
    bool move(std::int64_t x, std::int64_t y, std::int64_t step) {
        const std::size_t from = pixel(x, y);
        if (taken_[from] == 0 || !shares_.is_open(from)) return false;
        std::int64_t best = 0, best_x = 0, best_y = 0;
        for (const std::int64_t dy : {-step, std::int64_t{0}, step})
            for (const std::int64_t dx : {-step, std::int64_t{0}, step}) {
                const std::int64_t to_x = place(x + dx, columns_), to_y = place(y + dy, rows_);
                if (to_x < 0 || to_y < 0) continue;
                const std::size_t to = pixel(to_x, to_y);
                if (taken_[to] != 0 || !shares_.is_open(to)) continue;
                const std::int64_t change =
                    std::int64_t{error_[to]} - error_[from] + kernel(0, 0) - kernel(dx, dy);
                if (change < best) {
                    best = change;
                    best_x = to_x;
                    best_y = to_y;
                }
            }
        if (best == 0) return false;
        ask_after(kernel_.size() / 4);
        add(x, y, -1);
        add(best_x, best_y, 1);
        taken_[from] = 0;
        taken_[pixel(best_x, best_y)] = 1;
        return true;
    }

    const PixelShares& shares_;
    std::span<const std::int32_t> parts_;
    std::vector<std::uint8_t>& taken_;
    bool wraps_;
    std::int64_t columns_;
    std::int64_t rows_;
    double narrowest_;
    std::int64_t reach_x_ = 0;
    std::int64_t reach_y_ = 0;
    std::vector<std::int32_t> kernel_;
    std::vector<std::int32_t> error_;
};

}  // namespace

void descend_on_pixels(const Raster& raster, bool wraps, const PixelShares& shares,
                       std::vector<std::uint8_t>& taken) {
    const std::vector<std::int32_t> parts = shares.in_parts();
    const std::vector<double> deviations = deviations_of(shares, parts);
    if (!deviations.empty()) PixelDescent(raster, wraps, shares, parts, taken, deviations).run();
}

}  // namespace lacuna
