// What one number each says of a set: how much of the spectrum is free of noise, how far it
// oscillates beyond, and how near the set is to a hexagonal lattice.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/neighbours.h"
#include "analysis/radial.h"

namespace lacuna::analysis {

// Heck, Schloemer & Deussen, Blue Noise Sampling with Controlled Aliasing (ACM Transactions on
// Graphics 32, 2013), as their program psa computes it. With M(f) the mean power of all frequencies
// below f, the disk's largest f with M(f) < 0.1 that comes before M first exceeds 0.5 at or beyond
// sqrt(count) / 2 is where aliasing of a wave of half that frequency grows noisy: f / 2 is the
// effective Nyquist frequency. Given over sqrt(count) / 2, the Nyquist frequency of a square
// lattice: 1 for that lattice, 0 for white noise. None when M never exceeds 0.5.
std::optional<double> effective_nyquist(const Radial& radial);

// Oscillations, by the same authors: 10 times the root of the mean of (P - 1)^2 over the ring of
// frequencies from where P first comes near 1 (0.98) to ten times sqrt(count) / 2 beyond. 0 for
// white noise. The ring reaches three times as far as the periodogram, so P comes, as in their
// program, from the pair correlation g over distances x in mean spacings:
//   P(f) = 1 + 2 pi integral of (g(x) - 1) J0(2 pi f x) w(x) x dx,
// w being Blackman's window, which ends where g does. `g` is as of pair_correlation, better the
// mean over several sets: noise in it adds to the oscillations. None for fewer than kLeastReach of
// g, or when P stays under 0.98.
std::optional<double> oscillations(const std::vector<double>& g);
constexpr double kLeastReach = 2;  // mean spacings

// P at f, which is a frequency over sqrt(count), from g as above.
double power_from_pairs(const std::vector<double>& g, double f);

// Bond-orientational order (Nelson & Halperin 1979; Steinhardt et al. 1983): psi_6 of a point is
// the mean of exp(6 i angle) over the directions to its six nearest neighbours.
struct BondOrder {
    double global;       // |mean of psi_6|: 1 for a hexagonal lattice, 0 without a common direction
    double local;        // mean of |psi_6|: 1 for a hexagonal lattice; 0.37 for white noise
    std::size_t points;  // that were looked at: on a box, those farther from its edge than from
                         // their sixth neighbour
};
// None for fewer than seven points, or when none could be looked at.
std::optional<BondOrder> bond_order(const Neighbours& neighbours);

}  // namespace lacuna::analysis
