// Derives a number of dots from a picture's darkness and its number of pixels.
#include "stipple/dot_count.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/polling.h"
#include "files/point_files.h"

namespace lacuna::stippling {
namespace {

std::uint64_t rounded(double count) {
    return static_cast<std::uint64_t>(std::clamp(std::round(count), 1.0, kMostDots));
}

}  // namespace

double darkness_of(const Field& field) {
    // Several sums, because each addition waits for the one before.
    constexpr std::size_t kSums = 8;
    std::array<double, kSums> sums{};
    const std::size_t count = field.importance.size(), whole = count / kSums;
    for_each_polled(
        whole, ask,
        [&](std::size_t i) {
            for (std::size_t k = 0; k < kSums; ++k) sums[k] += field.importance[kSums * i + k];
        },
        kSums);
    for (std::size_t i = kSums * whole; i < count; ++i) sums[0] += field.importance[i];
    return std::accumulate(sums.begin(), sums.end(), 0.0) / static_cast<double>(count);
}

std::uint64_t dot_count(const Field& field, const Domain& domain) {
    constexpr double kPixelsPerDot = 16;  // of black: a dot then covers 4 x 4 pixels
    constexpr double kLeastSide = 512, kMostSide = 2048;
    const double longer =
        std::clamp<double>(std::max(field.columns, field.rows), kLeastSide, kMostSide);
    return rounded(darkness_of(field) * domain.width * longer * domain.height * longer /
                   kPixelsPerDot);
}

std::uint64_t default_count(const Field& field, const Domain& domain, const Sizing& sizing,
                            const drawing::Style& style) {
    return sizing.pens ? rounded(dots_for_ink(field, domain, sizing, style))
                       : dot_count(field, domain);
}

double dots_for_ink(const Field& field, const Domain& domain, const Sizing& sizing,
                    const drawing::Style& style) {
    const double scale = millimetres_per_unit(files::PointSet{{}, domain}, style);
    return darkness_of(density_of(field, sizing)) * domain.width * scale * domain.height * scale;
}

}  // namespace lacuna::stippling
