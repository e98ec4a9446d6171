// The cpu backend's inner loops over samples near a point or box, for the processor's vectors.
//
// Each loop exists in plain C++, with the arithmetic of kernels/portable/, and for AVX2
// (vectors_avx2.cpp). Both give the same numbers; tests run every version that the processor has,
// by name.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "backends/cpu/sized.h"
#include "plan/pixels.h"
#include "plan/plan.h"
#include "portable/ellipse.h"

namespace lacuna::cpu {

// A sample as a strip sees it: its distance in x, to the strip's far edge in exact, and its y.
struct Seen {
    std::uint32_t distance;
    std::uint32_t y;
    friend bool operator==(const Seen&, const Seen&) = default;
};

// An ellipse in single precision, which shows for most samples and boxes that the sample takes
// nothing from the box, or all of it. For the others, whole numbers decide (portable/ellipse.h).
//
// An offset becomes u = p dx, v = q dx + s dy. If u^2 + v^2 is less than
// `inside`, the ellipse holds the offset; if it is not less than `outside`, it does not.
struct FloatEllipse {
    float p;
    float q;
    float s;
    float inside;
    float outside;
};

inline FloatEllipse in_floats(const portable::Ellipse& e) {
    const float unit = 0x1p-30F / static_cast<float>(std::uint64_t{1} << e.shift);
    const float p = static_cast<float>(e.p) * unit;
    const float q = static_cast<float>(static_cast<std::int32_t>(e.q)) * unit;
    const float s = static_cast<float>(e.s) * unit;
    // Each product is off by less than 2^-22 of itself. Where |u| and |v| are about 1, |q dx| is at
    // most |q| / p, and |s dy| at most 1 more.
    const float off = (1 + std::abs(q) / p) * 0x1p-20F;
    const float least = off < 1 ? 1 - off : 0;
    return {p, q, s, least * least, (1 + off) * (1 + off)};
}

// Eight boxes, an array for each member. Those that are not set may have any members.
struct BoxBatch {
    static constexpr std::size_t kBoxes = 8;
    std::array<std::uint32_t, kBoxes> x{};
    std::array<std::uint32_t, kBoxes> width{};
    std::array<std::uint32_t, kBoxes> begin{};
    std::array<std::uint32_t, kBoxes> end{};

    Box operator[](std::size_t i) const { return {x[i], width[i], begin[i], end[i]}; }
    void set(std::size_t i, const Box& box) {
        x[i] = box.x;
        width[i] = box.width;
        begin[i] = box.begin;
        end[i] = box.end;
    }
};

struct Vectors {
    const char* name;
    // Whether one of 4 x 4 cells holds a sample closer to `at` than the radius. *cells is the
    // first; columns are `stride` entries apart. No coordinate wraps.
    bool (*is_any_closer)(const Sample* cells, std::size_t stride, Sample at,
                          std::uint64_t radius_squared);
    // Writes the chord of each sample, cut to [0, height). All distances are below the radius.
    void (*find_chords)(std::span<const Seen> seen, std::uint64_t radius_squared,
                        std::uint32_t height, Span* chords);

    // With a radius field: whether a sample is closer to `at` than both its own radius and
    // `radius`. An axis whose period is not 0 wraps.
    bool (*is_any_sized_closer)(const SizedSpan& samples, Sample at, std::uint32_t radius,
                                Sample periods);
    // With a radius field: bit i of touching[k] says whether sample k touches box i, and bit i of
    // the result whether some sample covers box i. Chords are those at the box's far edge;
    // their radius is the smaller of the sample's and that of the box. No wrapping.
    std::uint32_t (*find_touching)(const SizedSpan& samples, const BoxBatch& boxes,
                                   const std::uint32_t* radii_of_boxes, std::uint8_t* touching);
    // With ellipses: the first sample from number `from` onwards that lies in the ellipse around
    // `at`, or may do so: single precision cannot decide it. Returns the number of samples if there
    // is none. No wrapping.
    std::size_t (*next_in_ellipse)(const SizedSpan& samples, Sample at, const FloatEllipse& ellipse,
                                   std::size_t from);
    // find_touching with ellipses, of samples and of boxes. If single precision cannot decide, the
    // bit of touching[k] is set, and the bit of the result is not.
    std::uint32_t (*find_touching_ellipses)(const SizedSpan& samples,
                                            const FloatEllipse* of_samples, const BoxBatch& boxes,
                                            const FloatEllipse* of_boxes, std::uint8_t* touching);
};

// What the processor can run, the fastest first; the last is plain C++. Without a radius field, the
// others serve radii below kLargestVectorRadius only.
std::span<const Vectors* const> all_vectors();
inline constexpr std::uint32_t kLargestVectorRadius = std::uint32_t{1} << 30;  // squared: 2^60
// Null on processors without AVX2.
const Vectors* avx2_vectors();
// The fastest version that serves the radius.
const Vectors& vectors_for(std::uint32_t radius);

}  // namespace lacuna::cpu
