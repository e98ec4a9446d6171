// The inner loops for AVX2, written with Highway: see base/highway_avx2.h.
#include "backends/cpu/vectors.h"

#if defined(__x86_64__)

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "backends/cpu/vectors_avx2.cpp"
#include "base/highway_avx2.h"

HWY_BEFORE_NAMESPACE();
namespace lacuna::cpu {
namespace HWY_NAMESPACE {
#if HWY_TARGET == HWY_AVX2

namespace hn = hwy::HWY_NAMESPACE;

// A pair of 32-bit words is a 64-bit word: a sample's x is its lower half, y its upper half.
using Words = hn::ScalableTag<std::uint32_t>;
using Pairs = hn::ScalableTag<std::uint64_t>;
using Signed = hn::ScalableTag<std::int64_t>;
using Floats = hn::ScalableTag<float>;
using Doubles = hn::ScalableTag<double>;
constexpr Words kWords;
constexpr Pairs kPairs;
constexpr Signed kSigned;
constexpr Floats kFloats;
constexpr Doubles kDoubles;
using WordVector = hn::Vec<Words>;
using PairVector = hn::Vec<Pairs>;
using SignedVector = hn::Vec<Signed>;
using FloatVector = hn::Vec<Floats>;

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

bool is_any_closer(const Sample* cells, std::size_t stride, Sample at,
                   std::uint64_t radius_squared) {
    // A column of four samples is eight words.
    const hn::CappedTag<std::int32_t, 8> signs;
    const hn::Repartition<std::int64_t, decltype(signs)> squares;
    const hn::Repartition<std::uint64_t, decltype(signs)> pairs;
    const auto centre = hn::BitCast(signs, hn::Set(pairs, pair_of(at.x, at.y)));
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
        // Entries past the end may be anything; their n may be negative, which has no root.
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

// The squares of eight words, in two vectors: of the lower and of the upper word of each pair.
struct Squares {
    SignedVector even;
    SignedVector odd;
};
HWY_INLINE Squares squares_of(WordVector words) {
    const WordVector upper = words_of(hn::ShiftRight<32>(hn::BitCast(kPairs, words)));
    return {signed_of(low_squares(words)), signed_of(low_squares(upper))};
}
HWY_INLINE Squares sum_of(const Squares& a, const Squares& b) {
    return {hn::Add(a.even, b.even), hn::Add(a.odd, b.odd)};
}
// Where a is less than b.
HWY_INLINE hn::Mask<Words> less(const Squares& a, const Squares& b) {
    const auto bits_of = [](auto mask) {
        return hn::BitCast(kWords, hn::VecFromMask(kSigned, mask));
    };
    return hn::MaskFromVec(
        hn::OddEven(bits_of(hn::Lt(a.odd, b.odd)), bits_of(hn::Lt(a.even, b.even))));
}
HWY_INLINE WordVector all(std::uint32_t word) {
    return hn::Set(kWords, word);
}
HWY_INLINE WordVector distance(WordVector a, WordVector b) {
    return hn::Sub(hn::Max(a, b), hn::Min(a, b));
}

// The period of an axis that does not wrap. A radius field has coordinates of at most 2^30, so the
// distance around is never the smaller one.
constexpr std::uint32_t kNoPeriod = std::uint32_t{1} << 31;

bool is_any_sized_closer(const SizedSpan& samples, Sample at, std::uint32_t radius,
                         Sample periods) {
    const auto squared_distance = [&](const std::uint32_t* entries, std::uint32_t at,
                                      std::uint32_t period) {
        const WordVector straight = distance(hn::LoadU(kWords, entries), all(at));
        return squares_of(
            hn::Min(straight, hn::Sub(all(period != 0 ? period : kNoPeriod), straight)));
    };
    auto closer = hn::FirstN(kWords, 0);
    for (std::size_t i = 0; i < samples.count; i += hn::Lanes(kWords)) {
        const auto is_closer =
            less(sum_of(squared_distance(samples.x + i, at.x, periods.x),
                        squared_distance(samples.y + i, at.y, periods.y)),
                 squares_of(hn::Min(hn::LoadU(kWords, samples.radius + i), all(radius))));
        closer = hn::Or(closer, hn::And(hn::FirstN(kWords, samples.count - i), is_closer));
    }
    return !hn::AllFalse(kWords, closer);
}

// The distance from y to the interval [begin, last] and, in farthest_distance, to its farther end.
HWY_INLINE WordVector nearest_distance(WordVector y, WordVector begin, WordVector last) {
    const WordVector outside = hn::Sub(hn::Max(hn::Max(y, begin), last), hn::Min(y, begin));
    return hn::Sub(outside, hn::Sub(last, begin));
}
HWY_INLINE WordVector farthest_distance(WordVector y, WordVector begin, WordVector last) {
    return hn::Max(distance(y, begin), distance(y, last));
}

HWY_INLINE WordVector load(const std::array<std::uint32_t, BoxBatch::kBoxes>& of_boxes) {
    static_assert(BoxBatch::kBoxes == 8);
    return hn::LoadU(kWords, of_boxes.data());
}

std::uint32_t find_touching(const SizedSpan& samples, const BoxBatch& boxes,
                            const std::uint32_t* radii_of_boxes, std::uint8_t* touching) {
    const WordVector begin = load(boxes.begin);
    const WordVector radii = hn::LoadU(kWords, radii_of_boxes);
    const WordVector last = hn::Sub(load(boxes.end), all(1));
    const WordVector half = hn::ShiftRight<1>(load(boxes.width));
    const WordVector middle = hn::Add(load(boxes.x), half);
    auto covered = hn::FirstN(kWords, 0);
    for (std::size_t k = 0; k < samples.count; ++k) {
        const WordVector y = all(samples.y[k]);
        const Squares limits = squares_of(hn::Min(all(samples.radius[k]), radii));
        const Squares across = squares_of(hn::Add(distance(all(samples.x[k]), middle), half));
        const Squares near = squares_of(nearest_distance(y, begin, last));
        const Squares far = squares_of(farthest_distance(y, begin, last));
        hn::StoreMaskBits(kWords, less(sum_of(across, near), limits), touching + k);
        covered = hn::Or(covered, less(sum_of(across, far), limits));
    }
    std::uint8_t bits = 0;
    hn::StoreMaskBits(kWords, covered, &bits);
    return bits;
}

// How far words lie after another one. Their distance is less than 2^31.
HWY_INLINE FloatVector offset(WordVector at, std::uint32_t from) {
    const hn::RebindToSigned<Words> integers;
    return hn::ConvertTo(kFloats, hn::BitCast(integers, hn::Sub(at, all(from))));
}

std::size_t next_in_ellipse(const SizedSpan& samples, Sample at, const FloatEllipse& e,
                            std::size_t from) {
    for (std::size_t i = from; i < samples.count; i += hn::Lanes(kFloats)) {
        const FloatVector dx = offset(hn::LoadU(kWords, samples.x + i), at.x);
        const FloatVector dy = offset(hn::LoadU(kWords, samples.y + i), at.y);
        const FloatVector u = hn::Mul(hn::Set(kFloats, e.p), dx);
        const FloatVector v =
            hn::MulAdd(hn::Set(kFloats, e.s), dy, hn::Mul(hn::Set(kFloats, e.q), dx));
        const auto is_in = hn::Lt(hn::MulAdd(v, v, hn::Mul(u, u)), hn::Set(kFloats, e.outside));
        const auto first = hn::FindFirstTrue(kFloats, is_in);
        if (first >= 0) return std::min(i + static_cast<std::size_t>(first), samples.count);
    }
    return samples.count;
}

// An ellipse in each lane.
struct EllipseVectors {
    FloatVector p, q, s, inside, outside;
};
HWY_INLINE EllipseVectors all(const FloatEllipse& e) {
    return {hn::Set(kFloats, e.p), hn::Set(kFloats, e.q), hn::Set(kFloats, e.s),
            hn::Set(kFloats, e.inside), hn::Set(kFloats, e.outside)};
}
HWY_INLINE EllipseVectors load(const FloatEllipse* ellipses) {
    const auto load_member = [&](float FloatEllipse::*member) {
        std::array<float, BoxBatch::kBoxes> values;
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = ellipses[i].*member;
        return hn::LoadU(kFloats, values.data());
    };
    return {load_member(&FloatEllipse::p), load_member(&FloatEllipse::q),
            load_member(&FloatEllipse::s), load_member(&FloatEllipse::inside),
            load_member(&FloatEllipse::outside)};
}

// The sides of eight boxes, as offsets from a sample.
struct Sides {
    FloatVector left, right, low, high;
};
struct Reached {
    hn::Mask<Floats> touched, covered;
};
// What an ellipse holds of the lines on both sides of each box.
HWY_INLINE Reached reached_by(const EllipseVectors& e, const Sides& sides) {
    const auto at = [&](FloatVector dx) -> Reached {
        const FloatVector u = hn::Mul(e.p, dx);
        const FloatVector aside = hn::Mul(e.q, dx);
        const FloatVector bottom = hn::MulAdd(e.s, sides.low, aside);
        const FloatVector top = hn::MulAdd(e.s, sides.high, aside);
        const FloatVector near = hn::Max(hn::Max(bottom, hn::Neg(top)), hn::Zero(kFloats));
        const FloatVector far = hn::Max(hn::Neg(bottom), top);
        const FloatVector across = hn::Mul(u, u);
        return {hn::Lt(hn::MulAdd(near, near, across), e.outside),
                hn::Lt(hn::MulAdd(far, far, across), e.inside)};
    };
    const Reached left = at(sides.left), right = at(sides.right);
    return {hn::And(left.touched, right.touched), hn::And(left.covered, right.covered)};
}

std::uint32_t find_touching_ellipses(const SizedSpan& samples, const FloatEllipse* of_samples,
                                     const BoxBatch& boxes, const FloatEllipse* of_boxes,
                                     std::uint8_t* touching) {
    const WordVector x = load(boxes.x);
    const WordVector begin = load(boxes.begin);
    const WordVector last = hn::Sub(load(boxes.end), all(1));
    const WordVector right = hn::Add(x, hn::ShiftLeft<1>(hn::ShiftRight<1>(load(boxes.width))));
    const EllipseVectors around_boxes = load(of_boxes);
    auto covered = hn::FirstN(kFloats, 0);
    for (std::size_t k = 0; k < samples.count; ++k) {
        const std::uint32_t at_x = samples.x[k], at_y = samples.y[k];
        const Sides sides{offset(x, at_x), offset(right, at_x), offset(begin, at_y),
                          offset(last, at_y)};
        const Reached own = reached_by(all(of_samples[k]), sides);
        touching[k] = 0;
        if (hn::AllFalse(kFloats, own.touched)) continue;
        const Reached other = reached_by(around_boxes, sides);
        hn::StoreMaskBits(kFloats, hn::And(own.touched, other.touched), touching + k);
        covered = hn::Or(covered, hn::And(own.covered, other.covered));
    }
    std::uint8_t bits = 0;
    hn::StoreMaskBits(kFloats, covered, &bits);
    return bits;
}

constexpr Vectors kVectors{
    "AVX2",        is_any_closer,   find_chords,           is_any_sized_closer,
    find_touching, next_in_ellipse, find_touching_ellipses};

#endif
}  // namespace HWY_NAMESPACE
}  // namespace lacuna::cpu
HWY_AFTER_NAMESPACE();

#endif

#if !defined(__x86_64__) || HWY_ONCE

namespace lacuna::cpu {

const Vectors* avx2_vectors() {
#if defined(__x86_64__)
    if (has_avx2()) return &N_AVX2::kVectors;
#endif
    return nullptr;
}

}  // namespace lacuna::cpu

#endif
