// Angles, the same to the last bit on every machine, unlike std::sin and std::atan2: of products,
// quotients and square roots alone, which IEEE 754 defines to the last bit.
#pragma once

#include <cmath>
#include <numbers>

namespace lacuna {

struct Direction {
    double x;  // the cosine
    double y;  // the sine
};

// The direction of an angle of at most 2^20 radians either way, by Taylor's series around the
// nearest multiple of a right angle.
inline Direction direction_of(double angle) {
    // A right angle in two parts; the first has 33 bits, so that its multiples are exact.
    constexpr double kRight = 0x1.921fb544p+0, kRest = 0x1.0b4611a626331p-34;
    const double turns = std::nearbyint(angle / kRight);
    const double x = (angle - turns * kRight) - turns * kRest;
    double sine = 0, cosine = 0;
    constexpr int kTerms = 10;
    for (int term = kTerms; term > 0; --term) {  // both from the smallest term up
        sine = (1 - sine) * (x * x) / (2 * term * (2 * term + 1));
        cosine = (1 - cosine) * (x * x) / ((2 * term - 1) * 2 * term);
    }
    sine = x * (1 - sine);
    cosine = 1 - cosine;
    switch (static_cast<long>(turns) & 3) {
        case 0:
            return {cosine, sine};
        case 1:
            return {-sine, cosine};
        case 2:
            return {-cosine, -sine};
        default:
            return {sine, -cosine};
    }
}

// The angle from the x axis to (x, y), from -pi to pi; 0 for (0, 0).
inline double angle_of(double x, double y) {
    const double near = std::abs(x), far = std::abs(y);
    if (near == 0 && far == 0) return 0;
    // The tangent of an angle of at most 45 degrees, then of an eighth of it.
    double tangent = std::fmin(near, far) / std::fmax(near, far);
    constexpr int kHalvings = 3;
    for (int i = 0; i < kHalvings; ++i) tangent /= 1 + std::sqrt(1 + tangent * tangent);
    const double square = tangent * tangent;
    double series = 0;
    constexpr int kLastPower = 17;
    for (int power = kLastPower; power > 0; power -= 2) series = 1.0 / power - square * series;
    double angle = (1 << kHalvings) * tangent * series;
    if (far > near) angle = std::numbers::pi / 2 - angle;
    if (x < 0) angle = std::numbers::pi - angle;
    return y < 0 ? -angle : angle;
}

}  // namespace lacuna
