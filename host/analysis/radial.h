// A spectrum averaged around its centre: the power of each frequency over all directions, and
// whether all directions are alike.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/spectrum.h"

namespace lacuna::analysis {

// Width of an annulus in |k|: annulus a has the frequencies with 2a <= |k| < 2a + 2, without DC.
constexpr double kAnnulusWidth = 2;

struct Annulus {
    double frequency;   // mean |k| of its frequencies, over sqrt(count)
    double outer;       // 2a + 2, over sqrt(count)
    double power;       // mean P
    std::size_t modes;  // number of frequencies, in half of the plane

    // Anisotropy: the variance of P among these frequencies over its squared mean, in decibels
    // (Ulichney 1988, Lagae & Dutre 2008). If all directions are alike, it is -10 log10(sets): 0 dB
    // for one set, -10 dB for ten, because P then varies like the mean of `sets` exponential
    // variables. Empty if the power, or its variance, is zero up to rounding.
    std::optional<double> anisotropy_db;
};

struct Radial {
    std::vector<Annulus> annuli;  // only annuli that lie within the range

    // The annulus of a frequency |k| / sqrt(count); the last one if the frequency is beyond it.
    const Annulus& at(double frequency) const;

    const Annulus& peak() const;  // the annulus with the most power

    // Averaged over the annuli that have one, weighted by modes: few modes make it uncertain.
    std::optional<double> mean_anisotropy_db() const;
};

Radial radial_of(const Spectrum& spectrum);

// The mean of P / (power of the annulus) along a line through the periodogram's centre: 1 if the
// line is like the rest. For an unbiased set its standard error is 1 / sqrt(modes * sets).
struct LinePower {
    double ratio;
    std::size_t modes;
};
// The line kx = 0: how evenly points fill the domain along y. Empty if no annulus has power.
std::optional<LinePower> vertical_line(const Spectrum& spectrum, const Radial& radial);
// The line ky = 0: the same along x.
std::optional<LinePower> horizontal_line(const Spectrum& spectrum, const Radial& radial);

}  // namespace lacuna::analysis
