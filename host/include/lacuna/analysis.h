// Spectrum and statistics of point sets, as the command analyze reports them. Link lacuna::extras.
//
// What is promised
//   - Powers have a relative or absolute error of at most 1e-9 with any number of threads.
//   - Frequencies are in units of sqrt(count), and distances in units of the mean spacing,
//     sqrt(area / count): sets of different count and domain can be compared.
//   - Several sets in one domain are averaged. Time grows little faster than the count. Memory
//     grows with the count: about 400 bytes per point besides the points.
#pragma once

#include <lacuna/domain.h>
#include <lacuna/export.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace LACUNA_API lacuna {

// A ring of the periodogram P(k) = |sum over points of exp(-2 pi i k.x)|^2 / count, without k = 0.
struct Ring {
    double frequency = 0;  // mean |k| / sqrt(count) of its frequencies
    double power = 0;      // mean P: 1 for independent points
    // Variance of P over its squared mean, in dB (Ulichney 1988); -10 log10(sets) for isotropic
    // sets. Unset where power is 0.
    std::optional<double> anisotropy_db{};
};

// Statistics that do not exist, such as distances in sets of one point, are unset or empty.
struct Statistics {
    double mean_count = 0;
    std::optional<double> least_distance{};   // of all sets, in the domain's unit
    std::optional<double> mean_distance{};    // to the nearest other point
    std::optional<double> relative_radius{};  // least_distance over a hexagonal lattice's (Lagae &
                                              // Dutre 2008)
    std::vector<double> pair_correlation{};  // entry i: the mean of g over [i, i + 1) / 20 spacings
    std::vector<Ring> rings{};               // by rising frequency, up to max_frequency
    std::optional<double> effective_nyquist{};  // in units of sqrt(count) / 2 (Heck et al. 2013)
    std::optional<double> oscillations{};       // Heck et al. 2013
    std::optional<double> psi_6{};              // mean of |psi_6|: 1 for a hexagonal lattice
};

// `sets`: at least one, each with at least one point, all points inside the domain. `keep_going`,
// if given, is called on the calling thread with the fraction that is done, 0 to 1; returning false
// cancels. `max_frequency`: how far rings reach, in units of sqrt(count), over 0 and at most 1000;
// time and memory grow with its square. `threads`: at most 1024; 0 is one for each core. Throws
// BadRequest for arguments that are not as said here, Unavailable where the system refuses threads,
// and Cancelled.
Statistics analyze(std::span<const std::vector<Point>> sets, const Domain& domain = {},
                   const std::function<bool(double share)>& keep_going = {},
                   double max_frequency = 2, std::uint32_t threads = 0);

}  // namespace lacuna
