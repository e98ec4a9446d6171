// The inner loops in the words of AVX2, by way of Highway.
//
// Highway includes this file once more for AVX2 alone, which the rest of the library is not
// compiled for. Its own choice while the program runs is in a shared library, which a wheel would
// have to carry for the few lines at the end; and the words of AVX-512 bring nothing here.
#include "backends/cpu/vectors_avx2.h"

#if defined(__x86_64__)

#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "backends/cpu/vectors_avx2.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace lacuna::cpu {
namespace HWY_NAMESPACE {
#if HWY_TARGET == HWY_AVX2

namespace hn = hwy::HWY_NAMESPACE;

// Two words of 32 bits make one of 64: a sample's x is the lower, its y the upper.
using Words = hn::ScalableTag<std::uint32_t>;
using Pairs = hn::ScalableTag<std::uint64_t>;
using Signed = hn::ScalableTag<std::int64_t>;
using Doubles = hn::ScalableTag<double>;
constexpr Words kWords;
constexpr Pairs kPairs;
constexpr Signed kSigned;
constexpr Doubles kDoubles;
using WordVector = hn::Vec<Words>;
using PairVector = hn::Vec<Pairs>;
using SignedVector = hn::Vec<Signed>;

constexpr std::uint64_t pair_of(std::uint32_t low, std::uint32_t high) {
    return std::uint64_t{high} << 32U | low;
}
template <typename Entry>
HWY_INLINE PairVector load(const Entry* entries) {
    return hn::LoadU(kPairs, reinterpret_cast<const std::uint64_t*>(entries));
}
HWY_INLINE WordVector words_of(PairVector pairs) {
    return hn::BitCast(kWords, pairs);
}
HWY_INLINE SignedVector signed_of(PairVector pairs) {
    return hn::BitCast(kSigned, pairs);
}
// The squares of the lower words.
HWY_INLINE PairVector low_squares(WordVector words) {
    return hn::MulEven(words, words);
}
HWY_INLINE SignedVector squares_of(SignedVector numbers) {
    return signed_of(low_squares(hn::BitCast(kWords, numbers)));
}

bool is_any_closer(const Sample* cells, std::size_t stride, Sample place,
                   std::uint64_t radius_squared) {
    // A column of four samples is eight words.
    const hn::CappedTag<std::int32_t, 8> signs;
    const hn::Repartition<std::int64_t, decltype(signs)> squares;
    const hn::Repartition<std::uint64_t, decltype(signs)> pairs;
    const auto centre = hn::BitCast(signs, hn::Set(pairs, pair_of(place.x, place.y)));
    const auto limit = hn::Set(squares, static_cast<std::int64_t>(radius_squared));
    auto nearest = limit;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto column =
            hn::LoadU(pairs, reinterpret_cast<const std::uint64_t*>(cells + i * stride));
        const auto d = hn::Sub(hn::BitCast(signs, column), centre);
        const auto upper = hn::BitCast(signs, hn::ShiftRight<32>(hn::BitCast(pairs, d)));
        nearest = hn::Min(nearest, hn::Add(hn::MulEven(d, d), hn::MulEven(upper, upper)));
    }
    return !hn::AllFalse(squares, hn::Lt(nearest, limit));
}

// The largest whole numbers whose squares are at most n, for n < 2^60: the root of a double is
// wrong by one at most.
HWY_INLINE PairVector roots(SignedVector n) {
    const hn::Rebind<std::int32_t, Signed> halves;
    const auto root = hn::Sqrt(hn::ConvertTo(kDoubles, n));
    SignedVector whole = hn::PromoteTo(kSigned, hn::DemoteTo(halves, root));
    const SignedVector one = hn::Set(kSigned, 1);
    whole = hn::Sub(whole, hn::IfThenElseZero(hn::Gt(squares_of(whole), n), one));
    const SignedVector next = hn::Add(whole, one);
    whole = hn::IfThenElse(hn::Gt(squares_of(next), n), whole, next);
    return hn::BitCast(kPairs, whole);
}

void find_chords(std::span<const Seen> seen, std::uint64_t radius_squared, std::uint32_t height,
                 Span* chords) {
    const WordVector one = words_of(hn::Set(kPairs, 1));
    const WordVector top = words_of(hn::Set(kPairs, height));
    const SignedVector most = hn::Set(kSigned, static_cast<std::int64_t>(radius_squared) - 1);
    for (std::size_t i = 0; i < seen.size(); i += hn::Lanes(kPairs)) {
        const PairVector entries = load(seen.data() + i);
        const WordVector y = words_of(hn::ShiftRight<32>(entries));
        // What stands past the end may be nonsense: its root is of nothing.
        const SignedVector n =
            hn::Max(hn::Sub(most, signed_of(low_squares(words_of(entries)))), hn::Zero(kSigned));
        const WordVector reach = hn::Add(words_of(roots(n)), one);
        const WordVector above = hn::Add(y, one);
        const PairVector begin = hn::BitCast(kPairs, hn::Sub(above, hn::Min(above, reach)));
        const WordVector end = hn::Min(hn::Add(y, hn::Min(reach, top)), top);
        hn::StoreU(hn::Or(begin, hn::ShiftLeft<32>(hn::BitCast(kPairs, end))), kPairs,
                   reinterpret_cast<std::uint64_t*>(chords + i));
    }
}

constexpr Vectors kVectors{"AVX2", is_any_closer, find_chords};

#endif
}  // namespace HWY_NAMESPACE
}  // namespace lacuna::cpu
HWY_AFTER_NAMESPACE();

#endif

#if !defined(__x86_64__) || HWY_ONCE

namespace lacuna::cpu {

const Vectors* avx2_vectors() {
#if defined(__x86_64__)
    // What Highway asks of a processor before it uses AVX2 there.
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
        __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma"))
        return &N_AVX2::kVectors;
#endif
    return nullptr;
}

}  // namespace lacuna::cpu

#endif
