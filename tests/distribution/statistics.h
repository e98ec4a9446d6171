// Two-sample tests for point processes: each set gives one vector of statistics, and two groups of
// independent sets are compared by the means of these vectors.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plan/plan.h"

namespace lacuna::tests {

// For each set: pairs by distance from 0.9 r to 4.5 r, or nearest neighbours from 0.9 r to 2.1 r,
// in equal bins, divided by the number of points.
std::vector<double> pair_histogram(const Plan& plan, const std::vector<Sample>& samples);
std::vector<double> nearest_histogram(const Plan& plan, const std::vector<Sample>& samples);

struct Comparison {
    double largest_z = 0;  // largest difference of means over its standard error
    double sum_z_squared = 0;
    int entries = 0;  // number of entries that vary
    // Whether both groups may have one distribution. If they have, the largest z exceeds its limit
    // less than once in a thousand times. The limit of the sum of squares is five standard
    // deviations above its mean, because the entries of one set correlate.
    bool agree() const;
    std::string text() const;
};

// Each group is a list of vectors of one length, one vector for each set.
Comparison compare(const std::vector<std::vector<double>>& a,
                   const std::vector<std::vector<double>>& b);

// One group of sets, by their statistics.
struct Sets {
    std::vector<std::vector<double>> counts;
    std::vector<std::vector<double>> pairs;
    std::vector<std::vector<double>> nearest;

    // `samples` may be the first ones of a set of `count` samples.
    void add(const Plan& plan, const std::vector<Sample>& samples, std::size_t count);
};

struct Verdict {
    double count_z;
    Comparison pairs;
    Comparison nearest;

    bool same() const { return count_z < 3 && pairs.agree() && nearest.agree(); }
    std::string text() const;
};

Verdict compare(const Sets& a, const Sets& b);

struct Mean {
    double value = 0;
    double error = 0;  // standard error
};
Mean mean_of(const std::vector<double>& values);

}  // namespace lacuna::tests
