// Thins out crowds of samples.
#include "verify/bounds.h"

#include <array>
#include <functional>
#include <limits>
#include <utility>

namespace lacuna::verify {
namespace {

// The samples of a cell are thinned out only if they are more than this. Most cells have far fewer.
constexpr std::size_t kCrowd = 64;

// The squared distances from a point to the corners of a cell. If one point is nearer to all four
// corners than another point, then it is nearer to all spots of the cell.
using ToCorners = std::array<double, 4>;

ToCorners to_corners(const Cell& cell, Point p) {
    const double left = square(p.x - cell.left);
    const double right = square(p.x - cell.right);
    const double bottom = square(p.y - cell.bottom);
    const double top = square(p.y - cell.top);
    return {left + bottom, right + bottom, left + top, right + top};
}

}  // namespace

void thin_out(const Cell& cell, const Bounds& bounds, std::size_t before,
              std::vector<Disk>& samples, std::size_t begin) {
    const std::size_t count = samples.size() - begin;
    if (count <= kCrowd || 8 * count <= 7 * before) return;
    // For each corner the nearest sample, and the sample that covers it best.
    std::array<std::size_t, 8> chosen{};
    std::array<double, 8> least;
    least.fill(std::numeric_limits<double>::infinity());
    const auto choose = [&](std::size_t k, double value, std::size_t i) {
        if (value < std::exchange(least[k], std::min(least[k], value))) chosen[k] = i;
    };
    for (std::size_t i = begin; i < samples.size(); ++i) {
        const ToCorners squares = to_corners(cell, samples[i].at);
        for (std::size_t k = 0; k < 4; ++k) {
            const double distance = std::sqrt(squares[k]);
            choose(k, distance, i);
            choose(k + 4, distance - bounds.effective(samples[i]), i);
        }
    }
    std::array<Disk, 8> standing{};
    for (std::size_t k = 0; k < 8; ++k) standing[k] = samples[chosen[k]];
    std::size_t top = begin;
    for (std::size_t i = begin; i < samples.size(); ++i) {
        const Disk disk = samples[i];
        const ToCorners mine = to_corners(cell, disk.at);
        const auto replaces_it = [&](const Disk& other) {
            const ToCorners others = to_corners(cell, other.at);
            return bounds.effective(other) >= bounds.effective(disk) &&
                   other.factor >= disk.factor &&
                   std::equal(others.begin(), others.end(), mine.begin(), std::less_equal<>());
        };
        const bool is_chosen = std::find(chosen.begin(), chosen.end(), i) != chosen.end();
        if (is_chosen || std::none_of(standing.begin(), standing.end(), replaces_it))
            samples[top++] = disk;
    }
    samples.resize(top);
}

}  // namespace lacuna::verify
