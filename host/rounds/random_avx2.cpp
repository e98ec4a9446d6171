// Philox 4x32-10 (Salmon et al. 2011) for several counters at once, with AVX2 instructions through
// Highway, which includes this file a second time: see base/highway_avx2.h.
#include "rounds/random_run.h"

#if defined(__x86_64__)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rounds/random_avx2.cpp"
#include "base/highway_avx2.h"

HWY_BEFORE_NAMESPACE();
namespace lacuna {
namespace HWY_NAMESPACE {
#if HWY_TARGET == HWY_AVX2

namespace hn = hwy::HWY_NAMESPACE;

// Each word of a counter is the lower half of a 64-bit lane, because a product takes 64 bits. The
// upper half is ignored.
using Lanes = hn::ScalableTag<std::uint64_t>;
constexpr Lanes kLanes;
using Lane = hn::Vec<Lanes>;
constexpr hn::Repartition<std::uint32_t, Lanes> kHalves;

struct Counters {
    Lane words[4];
};

HWY_INLINE Lane product(Lane words, Lane by) {
    return hn::MulEven(hn::BitCast(kHalves, words), hn::BitCast(kHalves, by));
}

HWY_INLINE Counters philox_round(const Counters& c, Lane key0, Lane key1) {
    const Lane low = product(c.words[0], hn::Set(kLanes, 0xD2511F53));
    const Lane high = product(c.words[2], hn::Set(kLanes, 0xCD9E8D57));
    return {{hn::Xor(hn::Xor(hn::ShiftRight<32>(high), c.words[1]), key0), high,
             hn::Xor(hn::Xor(hn::ShiftRight<32>(low), c.words[3]), key1), low}};
}

HWY_INLINE Lane joined(Lane low, Lane high) {
    return hn::Or(hn::And(low, hn::Set(kLanes, 0xFFFFFFFF)), hn::ShiftLeft<32>(high));
}

// Works on two vectors of counters, so that one is multiplied while the other waits.
HWY_INLINE void fill_block(std::uint64_t seed, std::uint64_t first, RandomBits* run) {
    const Lane zero = hn::Zero(kLanes);
    const auto counters_from = [&](std::uint64_t index) {
        const Lane indices = hn::Iota(kLanes, index);
        return Counters{{indices, hn::ShiftRight<32>(indices), zero, zero}};
    };
    Counters a = counters_from(first);
    Counters b = counters_from(first + hn::Lanes(kLanes));
    auto key0 = static_cast<std::uint32_t>(seed);
    auto key1 = static_cast<std::uint32_t>(seed >> 32U);
    for (int round = 0; round < 10; ++round) {
        const Lane k0 = hn::Set(kLanes, key0);
        const Lane k1 = hn::Set(kLanes, key1);
        a = philox_round(a, k0, k1);
        b = philox_round(b, k0, k1);
        key0 += 0x9E3779B9;
        key1 += 0xBB67AE85;
    }
    auto* const out = reinterpret_cast<std::uint64_t*>(run);
    hn::StoreInterleaved2(joined(a.words[0], a.words[1]), joined(a.words[2], a.words[3]), kLanes,
                          out);
    hn::StoreInterleaved2(joined(b.words[0], b.words[1]), joined(b.words[2], b.words[3]), kLanes,
                          out + 2 * hn::Lanes(kLanes));
}

void fill(std::uint64_t seed, std::uint64_t first, std::span<RandomBits> run) {
    const std::size_t block = 2 * hn::Lanes(kLanes);
    std::size_t i = 0;
    for (; i + block <= run.size(); i += block) fill_block(seed, first + i, run.data() + i);
    for (; i < run.size(); ++i) run[i] = random_bits(seed, first + i);
}

constexpr RandomRun kRun{"AVX2", fill};

#endif
}  // namespace HWY_NAMESPACE
}  // namespace lacuna
HWY_AFTER_NAMESPACE();

#endif

#if !defined(__x86_64__) || HWY_ONCE

namespace lacuna {

const RandomRun* avx2_random_run() {
#if defined(__x86_64__)
    if (has_avx2()) return &N_AVX2::kRun;
#endif
    return nullptr;
}

}  // namespace lacuna

#endif
