// Sees through crowds.
#include "verify/bounds.h"

#include <array>
#include <functional>
#include <limits>
#include <utility>

#include "verify/corners.h"

namespace lacuna::verify {
namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();
// More disks than this, hardly fewer than those of the cell that was cut, are a crowd.
constexpr std::size_t kCrowdOfDisks = 64;

}  // namespace

void thin_out(const Cell& cell, const Bounds& bounds, std::size_t before, std::vector<Disk>& disks,
              std::size_t begin) {
    const std::size_t count = disks.size() - begin;
    if (count <= kCrowdOfDisks || 8 * count <= 7 * before) return;
    const Corners corners(cell);
    // Of each corner the nearest, and the one that covers it best.
    std::array<std::size_t, 8> chosen{};
    for (std::size_t k = 0; k < 4; ++k) {
        double nearest = kNoBound;
        double least_over = kNoBound;
        for (std::size_t i = begin; i < disks.size(); ++i) {
            const double distance = std::sqrt(corners.to(disks[i].at)[k]);
            if (distance < std::exchange(nearest, std::min(nearest, distance))) chosen[k] = i;
            const double over = distance - bounds.effective(disks[i]);
            if (over < std::exchange(least_over, std::min(least_over, over))) chosen[k + 4] = i;
        }
    }
    std::array<Disk, 8> standing{};
    for (std::size_t k = 0; k < 8; ++k) standing[k] = disks[chosen[k]];
    std::size_t top = begin;
    for (std::size_t i = begin; i < disks.size(); ++i) {
        const Disk disk = disks[i];
        const Corners::Squares mine = corners.to(disk.at);
        const auto stands_for_it = [&](const Disk& other) {
            const Corners::Squares others = corners.to(other.at);
            return bounds.effective(other) >= bounds.effective(disk) &&
                   std::equal(others.begin(), others.end(), mine.begin(), std::less_equal<>());
        };
        const bool is_standing = std::find(chosen.begin(), chosen.end(), i) != chosen.end();
        if (is_standing || std::none_of(standing.begin(), standing.end(), stands_for_it))
            disks[top++] = disk;
    }
    disks.resize(top);
}

}  // namespace lacuna::verify
