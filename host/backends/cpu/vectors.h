// The cpu backend's inner loops over samples near a place, for the vectors of the processor at
// hand.
//
// Each is there in plain C++, which says what it does with the arithmetic of kernels/portable/, and
// in the words of AVX2 (vectors_avx2.cpp). All give the same whole numbers; tests go through all
// that the processor has, by name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "backends/cpu/sized.h"
#include "plan/pixels.h"
#include "plan/plan.h"

namespace lacuna::cpu {

// A sample as a line sees it: the distance in x that counts, and the height.
struct Seen {
    std::uint32_t distance;
    std::uint32_t y;
    friend bool operator==(const Seen&, const Seen&) = default;
};

struct Vectors {
    const char* name;
    // Whether one of the 4 x 4 cells from *cells on, in columns `stride` apart, holds a sample
    // closer to the place than the radius. No coordinate wraps.
    bool (*is_any_closer)(const Sample* cells, std::size_t stride, Sample place,
                          std::uint64_t radius_squared);
    // The chord of each, cut to [0, height). All distances are below the radius.
    void (*find_chords)(std::span<const Seen> seen, std::uint64_t radius_squared,
                        std::uint32_t height, Span* chords);

    // With a radius field: whether a sample is closer to the place than both its own radius and
    // this one. Axes wrap after their periods, if these are not 0.
    bool (*is_any_sized_closer)(const SizedSpan& samples, Sample place, std::uint32_t radius,
                                Sample periods);
    // And what samples take from a place all along its width: their chords at its farther side,
    // each as long as the smaller of its own radius and this one makes it, of those that touch the
    // place. Returns how many; or kAll as soon as one covers all of it. Nothing wraps.
    std::size_t (*find_sized_chords)(const SizedSpan& samples, const Rectangle& place,
                                     std::uint32_t radius, Span* chords);
    static constexpr std::size_t kAll = ~std::size_t{0};
    // And of eight places: bit i of touching[k] tells whether sample k touches place i, and of what
    // is handed back whether one covers all of it.
    std::uint32_t (*find_touching)(const SizedSpan& samples, const Rectangle* places,
                                   std::uint32_t radius, std::uint8_t* touching);
    static constexpr std::size_t kPlaces = 8;
};

// So many entries past the end of what is read may be read, and past what is written overwritten.
inline constexpr std::size_t kVectorPadding = 8;

// All that the processor has, the fastest first; the last are those in plain C++. Except on a
// radius_field, the others are for radii below kLargestVectorRadius only.
std::span<const Vectors* const> all_vectors();
inline constexpr std::uint32_t kLargestVectorRadius = std::uint32_t{1} << 30;
// The fastest that are for the radius.
const Vectors& vectors_for(std::uint32_t radius);

}  // namespace lacuna::cpu
