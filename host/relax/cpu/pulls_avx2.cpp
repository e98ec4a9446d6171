// The inner loop of the Gaussian energy with AVX2 instructions through Highway, which includes this
// file a second time: see base/highway_avx2.h.
#include "relax/cpu/pulls.h"

#if defined(__x86_64__)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relax/cpu/pulls_avx2.cpp"
#include "base/highway_avx2.h"

HWY_BEFORE_NAMESPACE();
namespace lacuna::relaxing::cpu {
namespace HWY_NAMESPACE {
#if HWY_TARGET == HWY_AVX2

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::ScalableTag<std::int64_t>;
using Unsigned = hn::ScalableTag<std::uint64_t>;
using Halves = hn::ScalableTag<std::int32_t>;
constexpr Lanes kLanes;
constexpr Unsigned kUnsigned;
constexpr Halves kHalves;
using Lane = hn::Vec<Lanes>;
constexpr std::size_t kCount = 4;  // lanes of a vector

// The products of the lower halves.
HWY_INLINE Lane product(Lane a, Lane b) {
    return hn::MulEven(hn::BitCast(kHalves, a), hn::BitCast(kHalves, b));
}
// Shifts lanes of 64 bits to the right, as unsigned numbers.
template <typename Bits>
HWY_INLINE Lane shifted(Lane lanes, Bits bits) {
    return hn::BitCast(kLanes, hn::ShiftRightSame(hn::BitCast(kUnsigned, lanes), bits));
}

// Four weights in lower halves: gaussian_entry(), gaussian_rest() and gaussian_weight().
HWY_INLINE Lane weights_of(Lane squared, const std::int32_t* weights, int entry_bits) {
    const hn::Repartition<std::uint32_t, Lanes> halves;
    const auto entry =
        hn::Min(hn::BitCast(halves, shifted(squared, entry_bits)),
                hn::BitCast(halves, hn::Set(kLanes, std::int64_t{GAUSSIAN_ENTRIES})));
    const Lane offset = hn::ShiftLeft<2>(hn::BitCast(kLanes, entry));
    // An entry in the lower half, and the next one in the upper half.
    const Lane low =
        hn::GatherOffset(kLanes, reinterpret_cast<const std::int64_t*>(weights), offset);
    const Lane high = shifted(low, 32);
    const Lane rest = hn::And(shifted(squared, entry_bits - 16), hn::Set(kLanes, 0xffff));
    const Lane more = product(hn::Sub(high, low), rest);
    return hn::Add(low, shifted(more, 16));
}

struct Vectors {
    Lane x;
    Lane y;
};

HWY_INLINE std::int64_t sum_of(Lane lanes) {
    HWY_ALIGN std::int64_t values[kCount];
    hn::Store(lanes, kLanes, values);
    std::int64_t sum = 0;
    for (const std::int64_t value : values) sum += value;
    return sum;
}

// The samples' arrays, which the loop must not look up again after each store.
struct Arrays {
    const std::int64_t* x;
    const std::int64_t* y;
    std::int64_t* force_x;
    std::int64_t* force_y;
};

class Pull {
public:
    Pull(Pulled& samples, const std::int32_t* weights, std::uint32_t bits)
        : arrays_{samples.x.data(), samples.y.data(), samples.force_x.data(),
                  samples.force_y.data()},
          weights_(weights),
          entry_bits_(static_cast<int>(2 * bits - GAUSSIAN_ENTRY_BITS)) {}

    HWY_INLINE void add(const Run& run) {
        const Vectors at{hn::Set(kLanes, run.at_x), hn::Set(kLanes, run.at_y)};
        const std::size_t end = run.begin + run.count;
        std::size_t i = run.begin;
        for (; i + kCount <= end; i += kCount)
            add_four(
                at, i, [](const std::int64_t* from) { return hn::LoadU(kLanes, from); },
                [](Lane lanes, std::int64_t* to) { hn::StoreU(lanes, kLanes, to); },
                [](Lane lanes) { return lanes; });
        if (i == end) return;
        const auto mask = hn::FirstN(kLanes, end - i);
        add_four(
            at, i, [&](const std::int64_t* from) { return hn::MaskedLoad(mask, kLanes, from); },
            [&](Lane lanes, std::int64_t* to) { hn::BlendedStore(lanes, mask, kLanes, to); },
            [&](Lane lanes) { return hn::IfThenElseZero(mask, lanes); });
    }

    Force force() const { return {sum_of(sum_.x), sum_of(sum_.y)}; }

private:
    struct Vectors {
        Lane x;
        Lane y;
    };

    template <typename Load, typename Store, typename Keep>
    HWY_INLINE void add_four(const Vectors& at, std::size_t i, Load load, Store store, Keep keep) {
        const Lane dx = hn::Sub(at.x, load(arrays_.x + i));
        const Lane dy = hn::Sub(at.y, load(arrays_.y + i));
        const Lane weight =
            keep(weights_of(hn::Add(product(dx, dx), product(dy, dy)), weights_, entry_bits_));
        const Lane force_x = product(weight, dx), force_y = product(weight, dy);
        sum_.x = hn::Add(sum_.x, force_x);
        sum_.y = hn::Add(sum_.y, force_y);
        store(hn::Sub(load(arrays_.force_x + i), force_x), arrays_.force_x + i);
        store(hn::Sub(load(arrays_.force_y + i), force_y), arrays_.force_y + i);
    }

    Arrays arrays_;
    const std::int32_t* weights_;
    int entry_bits_;
    Vectors sum_{hn::Zero(kLanes), hn::Zero(kLanes)};
};

Force pull(std::span<const Run> runs, const std::int32_t* weights, std::uint32_t bits,
           Pulled& samples) {
    Pull pull(samples, weights, bits);
    for (const Run& run : runs) pull.add(run);
    return pull.force();
}

constexpr Puller kPuller{"AVX2", pull};

#endif
}  // namespace HWY_NAMESPACE
}  // namespace lacuna::relaxing::cpu
HWY_AFTER_NAMESPACE();

#endif

#if !defined(__x86_64__) || HWY_ONCE

namespace lacuna::relaxing::cpu {

const Puller* avx2_puller() {
#if defined(__x86_64__)
    if (has_avx2()) return &N_AVX2::kPuller;
#endif
    return nullptr;
}

}  // namespace lacuna::relaxing::cpu

#endif
