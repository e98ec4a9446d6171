// The inner loops in plain C++, and the choice of the fastest.
#include "backends/cpu/vectors.h"

#include <algorithm>
#include <array>
#include <vector>

#include "backends/cpu/plain_ellipses.h"
#include "backends/cpu/vectors_avx2.h"
#include "portable/chord.h"
#include "portable/distance.h"

namespace lacuna::cpu {
namespace {

bool is_any_closer(const Sample* cells, std::size_t stride, Sample at,
                   std::uint64_t radius_squared) {
    bool is_closer = false;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            is_closer |= portable::are_closer_on_box(at.x, at.y, cells[i * stride + j].x,
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

bool is_any_sized_closer(const SizedSpan& samples, Sample at, std::uint32_t radius,
                         Sample periods) {
    bool is_closer = false;
    for (std::size_t i = 0; i < samples.count; ++i) {
        const std::uint64_t limit = std::min(samples.radius[i], radius);
        is_closer |= portable::are_closer(samples.x[i], samples.y[i], at.x, at.y, periods.x,
                                          periods.y, limit * limit);
    }
    return is_closer;
}

std::size_t find_sized_chords(const SizedSpan& samples, const Box& box, std::uint32_t radius,
                              Span* chords) {
    const std::uint32_t half = box.width / 2;
    std::size_t count = 0;
    for (std::size_t i = 0; i < samples.count; ++i) {
        const std::uint64_t limit = std::min(samples.radius[i], radius);
        const std::uint32_t dx = portable::axis_distance(samples.x[i], box.x + half, 0) + half;
        const std::uint32_t y = samples.y[i];
        const auto is_within = [&](std::uint32_t dy) {
            return portable::squared_length(dx, dy) < limit * limit;
        };
        if (is_within(portable::farthest_distance(y, box.begin, box.end))) return Vectors::kAll;
        if (!is_within(portable::nearest_distance(y, box.begin, box.end))) continue;
        const std::uint32_t reach = portable::chord_reach(dx, limit * limit);
        chords[count++] = {y + 1 - std::min(y + 1, reach), y + reach};
    }
    return count;
}

std::uint32_t find_touching(const SizedSpan& samples, const Box* boxes, std::uint32_t radius,
                            std::uint8_t* touching) {
    std::uint32_t covered = 0;
    for (std::size_t k = 0; k < samples.count; ++k) {
        std::uint32_t touched = 0;
        for (std::size_t i = 0; i < Vectors::kBoxes; ++i) {
            std::array<Span, 1 + kVectorPadding> chord;
            const std::size_t count =
                find_sized_chords(samples.part(k, 1), boxes[i], radius, chord.data());
            touched |= std::uint32_t{count != 0} << i;
            covered |= std::uint32_t{count == Vectors::kAll} << i;
        }
        touching[k] = static_cast<std::uint8_t>(touched);
    }
    return covered;
}

constexpr Vectors kPlain{"plain",
                         is_any_closer,
                         find_chords,
                         is_any_sized_closer,
                         find_sized_chords,
                         find_touching,
                         plain::next_in_ellipse,
                         plain::find_touching_ellipses};

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
