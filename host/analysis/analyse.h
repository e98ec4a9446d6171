// Everything that is measured of one point set or of several, whose numbers are then averaged.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/domain.h"
#include "analysis/order.h"
#include "analysis/pairs.h"
#include "analysis/radial.h"
#include "analysis/spectrum.h"

namespace lacuna::analysis {

struct Counts {
    std::size_t least = 0;
    std::size_t most = 0;
    double mean = 0;
};

// None of this for sets of one point.
struct Distances {
    double least;            // of all sets, in the domain's unit
    double mean;             // to the nearest neighbour, in the domain's unit
    double relative_radius;  // the least of all sets; see pairs.h

    // Shares of the points whose nearest neighbour is [i, i + 1) * kNearestBin mean spacings away,
    // and what is left farther out.
    std::vector<double> nearest_shares;
    double nearest_beyond = 0;

    // The pair correlation by bins of kReportedPairBin, up to kReportedPairReach or half the
    // shorter side.
    std::vector<double> pair_correlation;

    // Its mean from the radius to kContactEnd radii. None where the radius is not known, or that is
    // more than half the shorter side.
    std::optional<double> contact;
};
constexpr double kNearestBin = 0.02;
constexpr std::size_t kNearestBins = 100;
constexpr std::size_t kFineBins = 10;  // of pair_correlation(), in one that is reported
constexpr double kReportedPairBin = kFineBins * kPairBin;
constexpr std::size_t kReportedPairBins = 100;
constexpr double kContactEnd = 1.02;

struct Effort {
    double max_frequency = kUsualFrequency;  // of the periodogram, |k| / sqrt(count): see range_for
    std::uint32_t threads = 0;               // at most 1024; 0: as many as the machine has
};

struct Analysis {
    Domain domain;
    double max_frequency = kUsualFrequency;
    std::size_t sets = 0;
    Counts counts;

    std::optional<double> radius;  // the sets' mean, if it is known of all
    // The mean of count * radius^2 / area: 0.6966 for maximal sets on a torus (docs/design.md,
    // section 5).
    std::optional<double> count_times_squared_radius;

    std::optional<Distances> distances;
    Spectrum spectrum;
    Radial radial;
    std::optional<LinePower> vertical_line;
    std::optional<LinePower> horizontal_line;
    std::optional<double> effective_nyquist;
    std::optional<double> oscillations;
    std::optional<BondOrder> bond_order;  // means; `points` is the sum
};

// Sets in one domain, at least one, each of at least one point, all in it, upper edges included.
// `radii` holds the radius of each set where it is known, or nothing at all.
// The result does not depend on the number of threads. Throws BadRequest as verify::check_domain,
// check_radius and range_for do and for more threads, Unavailable where the system makes no such
// threads, and Cancelled.
Analysis analyse(std::span<const std::vector<Point>> sets, const Domain& domain,
                 std::span<const std::optional<double>> radii, const KeepGoing& keep_going,
                 const Effort& effort = {});

// Throws BadRequest("max-frequency", ...) and BadRequest("threads", ...) as analyse() does for a
// set of one point.
void check_effort(const Effort& effort);

// Throws BadRequest("radius", ...) for one that is no finite number greater than 0.
void check_radius(double radius);

}  // namespace lacuna::analysis
