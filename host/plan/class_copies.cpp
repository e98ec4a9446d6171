// Distances and weights of classes in whole numbers.
#include "plan/class_copies.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

#include "checks/classes.h"

namespace lacuna {
namespace {

constexpr double kMostWeight = 65536;
// A class of a smaller share of the greatest weight counts as one of this share.
constexpr double kLeastShareOfWeight = 1 / kMostWeight;

// The factor of two classes, from the share of the least distance that they keep: rounded up to a
// multiple of 2^-20 or, if that would make their distance over half a grid unit longer, of 2^-32.
// The first is precise enough for short distances, whose sets were made with it before.
std::uint64_t factor_of(double share, std::uint32_t most_radius) {
    constexpr double kOne = static_cast<double>(FACTOR_ONE);
    const double coarse = std::ceil(share * 0x1p20) * 0x1p-20;
    const bool is_far_off = (coarse - share) * most_radius > 0.5;
    return static_cast<std::uint64_t>(is_far_off ? std::ceil(share * kOne) : coarse * kOne);
}

}  // namespace

ClassCopies::ClassCopies() : ClassCopies(1, std::array{1.0}, std::array{1.0}) {}

ClassCopies::ClassCopies(std::uint32_t count, std::span<const double> distances,
                         std::span<const double> weights, std::uint32_t most_radius)
    : count_(count), bits_(static_cast<std::uint32_t>(std::bit_width(last_of(count)))) {
    for (std::size_t i = 0; i < distances.size(); ++i)
        factors_[i / count * MOST_CLASSES + i % count] = factor_of(distances[i], most_radius);
    const double greatest = *std::max_element(weights.begin(), weights.end());
    for (const double weight : weights) {
        const double share = std::max(weight / greatest, kLeastShareOfWeight);
        weights_.push_back(
            weight == 0 ? 0 : static_cast<std::uint32_t>(std::lround(share * kMostWeight)));
    }
}

std::uint64_t ClassCopies::greatest_factor(std::uint32_t copy) const {
    const auto row = factors().subspan(copy * std::size_t{MOST_CLASSES}, count_);
    return *std::max_element(row.begin(), row.end());
}

std::uint64_t ClassCopies::factor_of_boxes(std::uint32_t copy) const {
    std::uint64_t least = factor(copy, copy);
    for (std::uint32_t other = 0; other < count_; ++other)  // at most twice as long
        if (factor(copy, other) != 0) least = std::min(least, 2 * factor(other, other));
    return least;
}

ClassCopies copies_of(const Request& request, std::uint32_t most_radius) {
    if (request.classes.names.empty()) return {};
    std::vector<double> weights = request.classes.weights;
    weights.resize(request.classes.names.size(), weights.empty() ? 1.0 : 0.0);
    return {static_cast<std::uint32_t>(weights.size()), distances_of(request.classes), weights,
            most_radius};
}

}  // namespace lacuna
