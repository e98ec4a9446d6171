// The cpu backend's inner loop of the Gaussian energy: the forces between one sample and many.
//
// The loop exists in plain C++, with the arithmetic of portable/gaussian.h, and for AVX2
// (pulls_avx2.cpp). Both give the same numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "relax/gaussian.h"

namespace lacuna::relaxing::cpu {

// Samples beside each other in memory that may be in reach of a sample at (at_x, at_y). Positions
// count modulo 2^32, so that `at` may be shifted by periods.
struct Run {
    std::size_t begin;
    std::size_t count;
    std::uint32_t at_x;
    std::uint32_t at_y;
};

// Positions, of which only the lower 32 bits count, and the sums of the forces on them.
struct Pulled {
    std::vector<std::int64_t> x, y, force_x, force_y;
};

struct Puller {
    const char* name;
    // Subtracts from the samples of the runs what the sample at `at` does to them, and returns what
    // they do to it. `weights` is GaussianField::weights. Nothing but the runs is read or written.
    Force (*pull)(std::span<const Run> runs, const std::int32_t* weights, std::uint32_t bits,
                  Pulled& samples);
};

// What the processor can run, the fastest first; the last is plain C++.
std::span<const Puller* const> all_pullers();

// Null if the processor has no AVX2.
const Puller* avx2_puller();

}  // namespace lacuna::relaxing::cpu
