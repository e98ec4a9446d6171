// The cpu backend's inner loops over samples near a point or box, for the processor's vectors.
//
// Each loop exists in plain C++, with the arithmetic of kernels/portable/, and for AVX2
// (vectors_avx2.cpp). Both give the same numbers; tests run every version that the processor has,
// by name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "backends/cpu/float_ellipse.h"
#include "backends/cpu/sized.h"
#include "plan/pixels.h"
#include "plan/plan.h"

namespace lacuna::cpu {

// A sample as a strip sees it: its distance in x, to the strip's far edge in exact, and its y.
struct Seen {
    std::uint32_t distance;
    std::uint32_t y;
    friend bool operator==(const Seen&, const Seen&) = default;
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
    // With a radius field: writes the chords that the samples cut from the box, at its far
    // edge. The chord's radius is the smaller of the sample's and `radius`. Samples that do not
    // touch the box are left out. Returns the number of chords, or kAll if one sample covers the
    // box. No wrapping.
    std::size_t (*find_sized_chords)(const SizedSpan& samples, const Box& box, std::uint32_t radius,
                                     Span* chords);
    static constexpr std::size_t kAll = ~std::size_t{0};
    // The same test for eight boxes: bit i of touching[k] says whether sample k touches box i, and
    // bit i of the result whether some sample covers box i.
    std::uint32_t (*find_touching)(const SizedSpan& samples, const Box* boxes, std::uint32_t radius,
                                   std::uint8_t* touching);
    static constexpr std::size_t kBoxes = 8;
    // With ellipses: the first sample from number `from` onwards that lies in the ellipse around
    // `at`, or may do so: single precision cannot decide it. Returns the number of samples if there
    // is none. No wrapping.
    std::size_t (*next_in_ellipse)(const SizedSpan& samples, Sample at, const FloatEllipse& ellipse,
                                   std::size_t from);
    // find_touching with ellipses, of samples and of boxes. If single precision cannot decide, the
    // bit of touching[k] is set, and the bit of the result is not.
    std::uint32_t (*find_touching_ellipses)(const SizedSpan& samples,
                                            const FloatEllipse* of_samples, const Box* boxes,
                                            const FloatEllipse* of_boxes, std::uint8_t* touching);
};

// Buffers are padded by this many entries: the loops read and write that far past the end.
inline constexpr std::size_t kVectorPadding = 8;

// What the processor can run, the fastest first; the last is plain C++. Without a radius field, the
// others serve radii below kLargestVectorRadius only.
std::span<const Vectors* const> all_vectors();
inline constexpr std::uint32_t kLargestVectorRadius = std::uint32_t{1} << 30;  // squared: 2^60
// The fastest version that serves the radius.
const Vectors& vectors_for(std::uint32_t radius);

}  // namespace lacuna::cpu
