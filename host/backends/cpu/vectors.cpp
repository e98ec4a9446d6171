// Two inner loops in plain C++, and the choice of the fastest.
#include "backends/cpu/vectors.h"

#include <vector>

#include "backends/cpu/vectors_avx2.h"
#include "portable/chord.h"
#include "portable/distance.h"

namespace lacuna::cpu {
namespace {

bool is_any_closer(const Sample* cells, std::size_t stride, Sample place,
                   std::uint64_t radius_squared) {
    bool is_closer = false;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            is_closer |= portable::conflicts_on_box(place.x, place.y, cells[i * stride + j].x,
                                                    cells[i * stride + j].y, radius_squared);
    return is_closer;
}

void find_chords(std::span<const Seen> seen, std::uint64_t radius_squared, std::uint32_t height,
                 Span* chords) {
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const std::uint32_t reach = portable::chord_reach(seen[i].distance, radius_squared);
        chords[i] = {portable::window_begin(0, seen[i].y, reach, height),
                     portable::window_end(0, seen[i].y, reach, height)};
    }
}

constexpr Vectors kPlain{"plain", is_any_closer, find_chords};

}  // namespace

std::span<const Vectors* const> all_vectors() {
    static const std::vector<const Vectors*> all = [] {
        std::vector<const Vectors*> found;
        if (avx2_vectors() != nullptr) found.push_back(avx2_vectors());
        found.push_back(&kPlain);
        return found;
    }();
    return all;
}

const Vectors& vectors_for(std::uint32_t radius) {
    return radius < kLargestVectorRadius ? *all_vectors().front() : kPlain;
}

}  // namespace lacuna::cpu
