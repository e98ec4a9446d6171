// The periodogram of a point set: exact sums at the frequencies of its domain.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/domain.h"

namespace lacuna::analysis {

// A frequency is (kx / width, ky / height) in cycles per unit of length, with whole numbers kx and
// ky: a wave that fits into the domain. DC, k = (0, 0), is left out. |k| is the frequency's length
// times the square root of the domain's area. In the unit square that is the length of (kx, ky). In
// any domain about pi |k|^2 frequencies lie below a given |k|.
struct Range {
    int kx_max;
    int ky_max;
};

// The default reach of a periodogram, as |k| / sqrt(count).
constexpr double kUsualFrequency = 2;

// A range that contains the disk |k| <= frequency * sqrt(count) + 3, which radial means up to that
// frequency need. Throws BadRequest("max-frequency", ...) unless 0 < frequency <= 1000, or if half
// the plane would have over 2^31 frequencies, which take 40 bytes each.
Range range_for(const Domain& domain, double count, double frequency = kUsualFrequency);

// The mean of the periodograms of several sets at the same frequencies,
//   P(k) = |sum over points of exp(-2 pi i (kx x / width + ky y / height))|^2 / count
// (Ulichney 1988; Lagae & Dutre 2008). Independent points have 1 on average.
struct Spectrum {
    Domain domain;
    Range range;
    std::size_t sets = 0;
    double count = 0;  // mean number of points in a set

    // For each kx from 0 to kx_max, the powers for ky from -ky_max to ky_max. The other half of the
    // plane has the same powers, because P(-k) = P(k).
    std::vector<double> powers;

    // Needs |kx| <= kx_max and |ky| <= ky_max. The power of DC is 0.
    double power(int kx, int ky) const;

    double magnitude(int kx, int ky) const;  // |k|, see Range

    // The uncertainty of P: where the sum is zero, rounding leaves a power of this order.
    double rounding() const { return 1e-20 * count; }
};

// The mean power at all frequencies below `frequency` times the root of the count, without DC.
// Empty if there is none.
std::optional<double> mean_power_below(const Spectrum& spectrum, double frequency);

// The powers of one set of at least one point, in the order of Spectrum::powers. Uses all cores;
// the result does not depend on their number. Every P is accurate to 1e-9 of itself or of 1. Throws
// Cancelled.
std::vector<double> periodogram(std::span<const Point> points, const Domain& domain, Range range,
                                const KeepGoing& keep_going);

// periodogram() uses fast_periodogram() of fast_sums.h for kManyPoints points or more, where it was
// measured to be faster. Below, it uses exact_periodogram(): matrix products, whose time grows with
// points times frequencies, and 24 bytes for each frequency of half the plane.
constexpr std::size_t kManyPoints = 1000;
std::vector<double> exact_periodogram(std::span<const Point> points, const Domain& domain,
                                      Range range, const KeepGoing& keep_going);

// The mean over one or more sets of one or more points. Throws Cancelled, and as range_for() does.
Spectrum mean_spectrum(std::span<const std::vector<Point>> sets, const Domain& domain,
                       const KeepGoing& keep_going, double frequency = kUsualFrequency);

}  // namespace lacuna::analysis
