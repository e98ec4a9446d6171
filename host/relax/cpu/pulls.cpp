// The inner loop in plain C++, and the choice of the fastest.
#include "relax/cpu/pulls.h"

#include <vector>

namespace lacuna::relaxing::cpu {
namespace {

Force pull(std::span<const Run> runs, const std::int32_t* weights, std::uint32_t bits,
           Pulled& samples) {
    Force force{0, 0};
    for (const Run& run : runs) {
        for (std::size_t i = run.begin; i < run.begin + run.count; ++i) {
            const auto difference = [](std::uint32_t at, std::int64_t other) {
                return portable::sign_extended(at - static_cast<std::uint32_t>(other));
            };
            const std::int64_t dx = difference(run.at_x, samples.x[i]);
            const std::int64_t dy = difference(run.at_y, samples.y[i]);
            const auto squared = static_cast<std::uint64_t>(dx * dx + dy * dy);
            const std::uint32_t entry = portable::gaussian_entry(squared, bits);
            const std::int64_t weight = portable::gaussian_weight(
                weights[entry], weights[entry + 1], portable::gaussian_rest(squared, bits));
            force.x += weight * dx;
            force.y += weight * dy;
            samples.force_x[i] -= weight * dx;
            samples.force_y[i] -= weight * dy;
        }
    }
    return force;
}

constexpr Puller kPlain{"plain", pull};

}  // namespace

std::span<const Puller* const> all_pullers() {
    static const std::vector<const Puller*> all = [] {
        std::vector<const Puller*> found;
        if (avx2_puller() != nullptr) found.push_back(avx2_puller());
        found.push_back(&kPlain);
        return found;
    }();
    return all;
}

}  // namespace lacuna::relaxing::cpu
