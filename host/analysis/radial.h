// A spectrum averaged around its centre: how strong each frequency is, whatever its direction, and
// whether all directions are alike.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/spectrum.h"

namespace lacuna::analysis {

// Width of an annulus in |k|: annulus a holds 2a <= |k| < 2a + 2, without DC.
constexpr double kAnnulusWidth = 2;

struct Annulus {
    double frequency;   // mean |k| of its frequencies, over sqrt(count)
    double outer;       // 2a + 2, over sqrt(count)
    double power;       // mean P
    std::size_t modes;  // frequencies of half the plane

    // Variance of P among its frequencies over its squared mean, in decibels (Ulichney 1988, Lagae
    // & Dutre 2008). Where directions are alike P is spread like the mean of as many exponential
    // variables as there are sets: -10 log10(sets), 0 dB for one and -10 dB for ten. None where the
    // power, or its variance, is zero but for rounding.
    std::optional<double> anisotropy_db;
};

struct Radial {
    std::vector<Annulus> annuli;  // whole ones only

    // The annulus that a frequency, |k| / sqrt(count), lies in; the last one for any beyond.
    const Annulus& at(double frequency) const;

    const Annulus& peak() const;  // of the most power

    // Over the annuli that have one, each counting as its modes: few modes scatter widely.
    std::optional<double> mean_anisotropy_db() const;
};

Radial radial_of(const Spectrum& spectrum);

// Mean of P / (power of the annulus) along a line through the centre of the periodogram: 1 where
// the line is like the rest. Its standard error is 1 / sqrt(modes * sets) for a set without bias.
struct LinePower {
    double ratio;
    std::size_t modes;
};
// kx = 0: how evenly points fill the domain along y. None when no annulus has any power.
std::optional<LinePower> vertical_line(const Spectrum& spectrum, const Radial& radial);
// ky = 0: along x.
std::optional<LinePower> horizontal_line(const Spectrum& spectrum, const Radial& radial);

}  // namespace lacuna::analysis
