// The inner loops in plain C++, and the choice of the fastest.
#include "backends/cpu/vectors.h"

#include <algorithm>
#include <vector>

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

std::uint32_t find_touching(const SizedSpan& samples, const BoxBatch& boxes,
                            const std::uint32_t* radii_of_boxes, std::uint8_t* touching) {
    std::uint32_t covered = 0;
    for (std::size_t k = 0; k < samples.count; ++k) {
        std::uint32_t touched = 0;
        for (std::size_t i = 0; i < BoxBatch::kBoxes; ++i) {
            const auto [x, width, begin, end] = boxes[i];
            const std::uint32_t half = width / 2;
            const std::uint32_t dx = portable::axis_distance(samples.x[k], x + half, 0) + half;
            const std::uint64_t limit = std::min(samples.radius[k], radii_of_boxes[i]);
            const auto is_within = [&](std::uint32_t dy) {
                return portable::squared_length(dx, dy) < limit * limit;
            };
            const std::uint32_t y = samples.y[k];
            touched |= std::uint32_t{is_within(portable::nearest_distance(y, begin, end))} << i;
            covered |= std::uint32_t{is_within(portable::farthest_distance(y, begin, end))} << i;
        }
        touching[k] = static_cast<std::uint8_t>(touched);
    }
    return covered;
}

// How far one number lies after another. Their distance is less than 2^31.
float offset(std::uint32_t at, std::uint32_t from) {
    return static_cast<float>(static_cast<std::int32_t>(at - from));
}

// How far from the middle of an ellipse, squared, a line from `low` to `high` at dx is.
struct FromMiddle {
    float nearest;
    float farthest;
};
FromMiddle from_middle(const FloatEllipse& e, float dx, float low, float high) {
    const float u = e.p * dx;
    const float bottom = e.q * dx + e.s * low;
    const float top = e.q * dx + e.s * high;
    const float near = std::max({bottom, -top, 0.0F});
    const float far = std::max(-bottom, top);
    return {u * u + near * near, u * u + far * far};
}

std::size_t next_in_ellipse(const SizedSpan& samples, Sample at, const FloatEllipse& e,
                            std::size_t from) {
    for (std::size_t i = from; i < samples.count; ++i) {
        const float dx = offset(samples.x[i], at.x);
        const float v = e.q * dx + e.s * offset(samples.y[i], at.y);
        if (e.p * dx * (e.p * dx) + v * v < e.outside) return i;
    }
    return samples.count;
}

std::uint32_t find_touching_ellipses(const SizedSpan& samples, const FloatEllipse* of_samples,
                                     const BoxBatch& boxes, const FloatEllipse* of_boxes,
                                     std::uint8_t* touching) {
    std::uint32_t covered = 0;
    for (std::size_t k = 0; k < samples.count; ++k) {
        std::uint32_t touched = 0;
        for (std::size_t i = 0; i < BoxBatch::kBoxes; ++i) {
            const Box box = boxes[i];
            const float low = offset(box.begin, samples.y[k]);
            const float high = offset(box.end - 1, samples.y[k]);
            bool touches = true, covers = true;
            for (const std::uint32_t side : {box.x, box.x + box.width / 2 * 2})
                for (const FloatEllipse* e : {of_samples + k, of_boxes + i}) {
                    const FromMiddle at = from_middle(*e, offset(side, samples.x[k]), low, high);
                    touches &= at.nearest < e->outside;
                    covers &= at.farthest < e->inside;
                }
            touched |= std::uint32_t{touches} << i;
            covered |= std::uint32_t{covers} << i;
        }
        touching[k] = static_cast<std::uint8_t>(touched);
    }
    return covered;
}

constexpr Vectors kPlain{"plain",       is_any_closer,   find_chords,           is_any_sized_closer,
                         find_touching, next_in_ellipse, find_touching_ellipses};

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
