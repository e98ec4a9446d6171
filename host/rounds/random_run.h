// The random bits of draws that follow one another, in the vectors of the processor at hand.
//
// Once in plain C++, a call of random_bits each, and once in the words of AVX2 (random_avx2.cpp),
// with the same bits.
#pragma once

#include <cstdint>
#include <span>

#include "rounds/random.h"

namespace lacuna {

struct RandomRun {
    const char* name;
    // run[i] = random_bits(seed, first + i).
    void (*fill)(std::uint64_t seed, std::uint64_t first, std::span<RandomBits> run);
};

// Those that this processor has, the fastest first; the last is the plain one.
std::span<const RandomRun* const> all_random_runs();

inline void random_run(std::uint64_t seed, std::uint64_t first, std::span<RandomBits> run) {
    static const RandomRun& fastest = *all_random_runs().front();
    fastest.fill(seed, first, run);
}

}  // namespace lacuna
