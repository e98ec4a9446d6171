// The random bits of consecutive draws, with the vector instructions of the processor.
//
// There are two versions with the same bits: plain C++, which calls random_bits for each draw, and
// AVX2 (random_avx2.cpp).
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

// The versions that this processor can run, the fastest first; the last one is plain C++.
std::span<const RandomRun* const> all_random_runs();

// Null if the processor has no AVX2.
const RandomRun* avx2_random_run();

inline void random_run(std::uint64_t seed, std::uint64_t first, std::span<RandomBits> run) {
    static const RandomRun& fastest = *all_random_runs().front();
    fastest.fill(seed, first, run);
}

}  // namespace lacuna
