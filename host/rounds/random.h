// Counter-based random numbers: draw k of seed s is a function of (s, k) and of nothing else.
#pragma once

#include <Random123/philox.h>

#include <cstdint>

namespace lacuna {

struct RandomBits {
    std::uint64_t first;
    std::uint64_t second;
};

// Philox 4x32-10 of counter (index, stream) with key `seed`.
inline RandomBits random_bits(std::uint64_t seed, std::uint64_t index, std::uint32_t stream = 0) {
    const auto low = [](std::uint64_t a) { return static_cast<std::uint32_t>(a); };
    const auto high = [](std::uint64_t a) { return static_cast<std::uint32_t>(a >> 32); };
    const auto join = [](std::uint32_t l, std::uint32_t h) { return std::uint64_t{h} << 32 | l; };
    const r123::Philox4x32::ctr_type counter = {{low(index), high(index), stream, 0}};
    const r123::Philox4x32::key_type key = {{low(seed), high(seed)}};
    const auto words = r123::Philox4x32{}(counter, key);
    return {join(words[0], words[1]), join(words[2], words[3])};
}

// A whole number in [0, range), from 64 random bits. The probability of any interval has an error
// of less than 2^-64.
inline std::uint64_t scaled(std::uint64_t bits, std::uint64_t range) {
    __extension__ using Wide = unsigned __int128;
    return static_cast<std::uint64_t>(Wide{bits} * range >> 64);
}

}  // namespace lacuna
