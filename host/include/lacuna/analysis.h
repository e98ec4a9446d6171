// Spectrum and statistics of point sets, as the command analyze tells them. Link lacuna::extras.
//
// What is promised
//   - Powers are exact sums, right to 1e-9 of themselves or of 1, whatever the number of threads.
//   - Curves over frequency are in units of sqrt(count) and curves over distance in units of the
//     mean spacing, sqrt(area / count): sets of any count and domain compare.
//   - Several sets in one domain are averaged. The time grows little faster than the count, and
//     memory with it: some 400 bytes a point beside the points.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace lacuna {

// A ring of the periodogram, P(k) = |sum over points of exp(-2 pi i k.x)|^2 / count, without DC.
struct Ring {
    double frequency;  // mean |k| / sqrt(count) of its frequencies
    double power;      // mean P: 1 for independent points
    // Variance of P over its squared mean, in dB (Ulichney 1988): -10 log10(sets) where all
    // directions are alike. None where there is no power.
    std::optional<double> anisotropy_db;
};

// What is not known, such as distances of one point, is unset or empty.
struct Statistics {
    double mean_count = 0;
    std::optional<double> least_distance;   // of all sets, in the domain's unit
    std::optional<double> mean_distance;    // to the nearest other point
    std::optional<double> relative_radius;  // least_distance over a hexagonal lattice's (Lagae &
                                            // Dutre 2008)
    std::vector<double> pair_correlation;   // entry i: the mean of g over [i, i + 1) / 20 spacings
    std::vector<Ring> rings;                // by rising frequency, up to max_frequency
    std::optional<double> effective_nyquist;  // over sqrt(count) / 2 (Heck et al. 2013)
    std::optional<double> oscillations;       // Heck et al. 2013
    std::optional<double> psi_6;              // mean of |psi_6|: 1 for a hexagonal lattice
};

// `sets`, at least one, each of at least one point, all inside the domain. `keep_going`, if there
// is one, is told on the calling thread how much is done, 0 to 1; false ends the work. Rings reach
// to `max_frequency` in units of sqrt(count), over 0 and at most 1000; time and memory grow with
// its square. `threads`: at most 1024; 0 is as many as the machine has. Throws BadRequest for a
// domain that makes no sense, no set, an empty set, a point outside or other numbers than these,
// Unavailable where the system makes no threads, and Cancelled.
Statistics analyze(std::span<const std::vector<Point>> sets, double width = 1, double height = 1,
                   Boundary boundary = Boundary::box,
                   const std::function<bool(double share)>& keep_going = {},
                   double max_frequency = 2, std::uint32_t threads = 0);

}  // namespace lacuna
