// The inner loops over samples with ellipses in plain C++.
#include "backends/cpu/plain_ellipses.h"

#include <algorithm>

namespace lacuna::cpu {
namespace {

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

}  // namespace

std::size_t plain::next_in_ellipse(const SizedSpan& samples, Sample at, const FloatEllipse& e,
                                   std::size_t from) {
    for (std::size_t i = from; i < samples.count; ++i) {
        const float dx = offset(samples.x[i], at.x);
        const float v = e.q * dx + e.s * offset(samples.y[i], at.y);
        if (e.p * dx * (e.p * dx) + v * v < e.outside) return i;
    }
    return samples.count;
}

std::uint32_t plain::find_touching_ellipses(const SizedSpan& samples,
                                            const FloatEllipse* of_samples, const Box* boxes,
                                            const FloatEllipse* of_boxes, std::uint8_t* touching) {
    std::uint32_t covered = 0;
    for (std::size_t k = 0; k < samples.count; ++k) {
        std::uint32_t touched = 0;
        for (std::size_t i = 0; i < Vectors::kBoxes; ++i) {
            const Box& box = boxes[i];
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

}  // namespace lacuna::cpu
