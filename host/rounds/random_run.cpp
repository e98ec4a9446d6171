// Random bits in plain C++, and the choice of the fastest version.
#include "rounds/random_run.h"

#include <cstddef>
#include <vector>

namespace lacuna {
namespace {

void fill(std::uint64_t seed, std::uint64_t first, std::span<RandomBits> run) {
    for (std::size_t i = 0; i < run.size(); ++i) run[i] = random_bits(seed, first + i);
}

constexpr RandomRun kPlainRun{"plain", fill};

}  // namespace

std::span<const RandomRun* const> all_random_runs() {
    static const std::vector<const RandomRun*> all = [] {
        std::vector<const RandomRun*> found;
        if (avx2_random_run() != nullptr) found.push_back(avx2_random_run());
        found.push_back(&kPlainRun);
        return found;
    }();
    return all;
}

}  // namespace lacuna
