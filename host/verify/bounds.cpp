// Thins out crowds of samples.
#include "verify/bounds.h"

#include <array>
#include <functional>
#include <limits>
#include <utility>

#include "verify/ellipse_bounds.h"

namespace lacuna::verify {
namespace {

// The samples of a cell are thinned out only if they are more than this. Most cells have far fewer.
constexpr std::size_t kCrowd = 64;

}  // namespace

template <typename Sample>
void thin_out(const Cell& cell, const Bounds<Sample>& bounds, std::size_t before,
              std::vector<Sample>& samples, std::size_t begin) {
    const std::size_t count = samples.size() - begin;
    if (count <= kCrowd || 8 * count <= 7 * before || !bounds.can_thin_out()) return;
    // For each score the sample that has the least one.
    decltype(bounds.scores(bounds.to_corners(cell, samples[begin]), samples[begin])) least;
    least.fill(std::numeric_limits<double>::infinity());
    std::array<std::size_t, least.size()> chosen{};
    for (std::size_t i = begin; i < samples.size(); ++i) {
        const auto scores = bounds.scores(bounds.to_corners(cell, samples[i]), samples[i]);
        for (std::size_t k = 0; k < least.size(); ++k)
            if (scores[k] < std::exchange(least[k], std::min(least[k], scores[k]))) chosen[k] = i;
    }
    struct Standing {
        Sample sample;
        decltype(bounds.to_corners(cell, samples[begin])) corners;
    };
    std::array<Standing, least.size()> standing{};
    for (std::size_t k = 0; k < least.size(); ++k)
        standing[k] = {samples[chosen[k]], bounds.to_corners(cell, samples[chosen[k]])};
    std::size_t top = begin;
    for (std::size_t i = begin; i < samples.size(); ++i) {
        const Sample sample = samples[i];
        const auto mine = bounds.to_corners(cell, sample);
        const auto replaces_it = [&](const Standing& other) {
            return bounds.covers_as_much(other.sample, sample) &&
                   std::equal(mine.begin(), mine.end(), other.corners.begin(),
                              std::greater_equal<>());
        };
        const bool is_chosen = std::find(chosen.begin(), chosen.end(), i) != chosen.end();
        if (is_chosen || std::none_of(standing.begin(), standing.end(), replaces_it))
            samples[top++] = sample;
    }
    samples.resize(top);
}

template void thin_out(const Cell&, const Bounds<Disk>&, std::size_t, std::vector<Disk>&,
                       std::size_t);
template void thin_out(const Cell&, const Bounds<Ellipse>&, std::size_t, std::vector<Ellipse>&,
                       std::size_t);

}  // namespace lacuna::verify
