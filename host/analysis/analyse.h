// All measures of one point set, or their averages over several sets.
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

// Measures of distance. They do not exist if a set has only one point.
struct Distances {
    double least;            // the least over all sets, in the domain's unit
    double mean;             // mean distance to the nearest neighbour, in the domain's unit
    double relative_radius;  // of the set where it is least; see pairs.h

    // Entry i is the fraction of points whose nearest neighbour is [i, i + 1) * kNearestBin mean
    // spacings away. nearest_beyond is the fraction with a farther one.
    std::vector<double> nearest_shares;
    double nearest_beyond = 0;

    // The pair correlation in bins of kReportedPairBin, up to kReportedPairReach or half the
    // domain's shorter side, whichever is less.
    std::vector<double> pair_correlation;

    // The mean of the pair correlation from the radius to kContactEnd radii. Empty if the radius is
    // unknown, or if that is more than half the shorter side.
    std::optional<double> contact;
};
constexpr double kNearestBin = 0.02;
constexpr std::size_t kNearestBins = 100;
constexpr std::size_t kFineBins = 10;  // bins of pair_correlation() in one reported bin
constexpr double kReportedPairBin = kFineBins * kPairBin;
constexpr std::size_t kReportedPairBins = 100;
constexpr double kContactEnd = 1.02;

struct Effort {
    double max_frequency = kUsualFrequency;  // of the periodogram, |k| / sqrt(count): see range_for
    std::uint32_t threads = 0;               // at most 1024; 0: one for each core
};

struct Analysis {
    Domain domain;
    double max_frequency = kUsualFrequency;
    std::size_t sets = 0;
    Counts counts;

    std::optional<double> radius;  // mean over the sets; empty if one is unknown
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
    std::optional<BondOrder> bond_order;  // means, but `points` is the sum
};

// Analyses sets in one domain: at least one set, each with at least one point. Points may lie on
// the domain's upper edges. `radii` holds each set's radius, if it is known, or is empty.
// Everything is computed from the domain's corner on. The result does not depend on the number of
// threads. Throws BadRequest as check_domain, check_radius and range_for do, and for too
// many threads; Unavailable if the system cannot create the threads; and Cancelled.
Analysis analyse(std::span<const std::vector<Point>> sets, const Domain& domain,
                 std::span<const std::optional<double>> radii, const KeepGoing& keep_going,
                 const Effort& effort = {});

// Checks the effort for a set of one point. Throws BadRequest("max-frequency", ...) or
// BadRequest("threads", ...) as analyse() does.
void check_effort(const Effort& effort);

// Throws BadRequest("radius", ...) unless the radius is a finite number greater than 0.
void check_radius(double radius);

}  // namespace lacuna::analysis
