// Measures of one number: how much of the spectrum is free of noise, how strongly it oscillates
// above that, and how near the set is to a hexagonal lattice.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/neighbours.h"
#include "analysis/radial.h"

namespace lacuna::analysis {

// The effective Nyquist frequency of Heck, Schloemer & Deussen, Blue Noise Sampling with Controlled
// Aliasing (ACM Transactions on Graphics 32, 2013), computed as their program psa does. M(f) is the
// mean power of all frequencies below f. Let f be the largest frequency with M(f) < 0.1 before M
// first exceeds 0.5 at or beyond sqrt(count) / 2. A wave of frequency f / 2 is where aliasing
// begins to look noisy. The result is f / 2 over sqrt(count) / 2, a square lattice's Nyquist
// frequency: 1 for that lattice, 0 for white noise. Empty if M never exceeds 0.5.
std::optional<double> effective_nyquist(const Radial& radial);

// Oscillations, by the same authors: 10 times the root mean square of P - 1 over a ring of
// frequencies. The ring begins where P first reaches 0.98 and is ten times sqrt(count) / 2 wide.
// White noise has 0. The ring reaches three times as far as the periodogram. So P is computed, as
// in their program, from the pair correlation g over distances x in mean spacings:
//   P(f) = 1 + 2 pi integral of (g(x) - 1) J0(2 pi f x) w(x) x dx,
// where w is Blackman's window, which ends where g does. `g` comes from pair_correlation(); a mean
// over several sets is better, because its noise adds to the oscillations. Empty if g is shorter
// than kLeastReach, or if P stays under 0.98.
std::optional<double> oscillations(const std::vector<double>& g);
constexpr double kLeastReach = 2;  // mean spacings

// P at f, a frequency over sqrt(count), computed from g by the formula above.
double power_from_pairs(const std::vector<double>& g, double f);

// Bond-orientational order (Nelson & Halperin 1979; Steinhardt et al. 1983): psi_6 of a point is
// the mean of exp(6 i angle) over the directions to its six nearest neighbours.
struct BondOrder {
    double global;       // |mean of psi_6|: 1 for a hexagonal lattice, 0 without a common direction
    double local;        // mean of |psi_6|: 1 for a hexagonal lattice, 0.37 for white noise
    std::size_t points;  // number of points used: on a box, points that are farther
                         // from its edge than from their sixth neighbour
};
// Empty for fewer than seven points, or if no point could be used.
std::optional<BondOrder> bond_order(const Neighbours& neighbours);

}  // namespace lacuna::analysis
