// The pixels of a mask that are near to lines.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace lacuna::domains {

// The first pixel whose middle is at or above `at`. The result is clamped to the mask, so that the
// ends of two adjoining pieces always agree.
inline std::uint32_t first_middle_from(double at, std::uint32_t pixels) {
    return static_cast<std::uint32_t>(
        std::clamp(std::ceil(at - 0.5), 0.0, static_cast<double>(pixels)));
}

// A mask of the pixels whose middles are nearer than `reach` to the rings. `scale` has pixels per
// unit of the domain, along x and y; `near` is the mask with zeros.
Mask near_rings(std::span<const PolygonRing> rings, double reach, Point scale, Mask near);

}  // namespace lacuna::domains
