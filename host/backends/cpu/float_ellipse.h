// Ellipses in floats, to tell quickly that a sample takes nothing from a box, or all of it. Where
// floats cannot tell, whole numbers decide (portable/ellipse.h).
#pragma once

#include <cmath>
#include <cstdint>

#include "portable/ellipse.h"

namespace lacuna::cpu {

// The map of an ellipse: an offset becomes u = p dx, v = q dx + s dy. If u^2 + v^2 is less than
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

}  // namespace lacuna::cpu
