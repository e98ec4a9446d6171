// The periodogram of a point set: exact sums at the frequencies of its domain.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/domain.h"

namespace lacuna::analysis {

// Frequencies are (kx / width, ky / height) in cycles a unit of length, kx and ky whole numbers:
// the waves that fit into the domain, which DC, k = (0, 0), is left out of. In the unit square that
// is k itself. |k| stands for the frequency's length times the square root of the domain's area, so
// that a domain of any shape and size has as many frequencies below a |k| as the unit square.
struct Range {
    int kx_max;
    int ky_max;
};

// How far a periodogram reaches where nothing else is said: |k| / sqrt(count).
constexpr double kUsualFrequency = 2;

// Far enough for the whole disk |k| <= frequency * sqrt(count) + 3: what radial means up to that
// frequency need. Throws BadRequest("max-frequency", ...) for a frequency that is not over 0 and at
// most 1000, and where half the plane would have over 2^31 frequencies, each of 40 bytes.
Range range_for(const Domain& domain, double count, double frequency = kUsualFrequency);

// The mean of the periodograms of several sets at the same frequencies,
//   P(k) = |sum over points of exp(-2 pi i (kx x / width + ky y / height))|^2 / count
// (Ulichney 1988; Lagae & Dutre 2008): 1 on average where points are independent.
struct Spectrum {
    Domain domain;
    Range range;
    std::size_t sets = 0;
    double count = 0;  // of points in a set, on average

    // kx from 0 to kx_max, and for each of them ky from -ky_max to ky_max. The other half of the
    // plane is the same once more, as P(-k) = P(k).
    std::vector<double> powers;

    // |kx| <= kx_max and |ky| <= ky_max. DC has the power 0.
    double power(int kx, int ky) const;

    double magnitude(int kx, int ky) const;  // |k|, see Range

    // P is no better known than this: rounding leaves so much where the sum is zero.
    double rounding() const { return 1e-20 * count; }
};

// The powers, in the order of Spectrum::powers, of one set of at least one point. On all cores; the
// result does not depend on their number. Every P is right to 1e-9 of itself or of 1. Throws
// Cancelled.
std::vector<double> periodogram(std::span<const Point> points, const Domain& domain, Range range,
                                const KeepGoing& keep_going);

// How it is made: from so many points on by fast_periodogram(), see fast_sums.h, where that was
// measured to be the faster one, and below as matrix products, which take time that grows with the
// product of points and frequencies, and 24 bytes a frequency of half the plane.
constexpr std::size_t kManyPoints = 1000;
std::vector<double> exact_periodogram(std::span<const Point> points, const Domain& domain,
                                      Range range, const KeepGoing& keep_going);

// Of at least one set, each of at least one point. Throws Cancelled, and BadRequest as range_for().
Spectrum mean_spectrum(std::span<const std::vector<Point>> sets, const Domain& domain,
                       const KeepGoing& keep_going, double frequency = kUsualFrequency);

}  // namespace lacuna::analysis
