// Two-sample tests for point processes: each set gives one vector of statistics, and two groups of
// independent sets are compared by the means of these vectors.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plan.h"

namespace lacuna::tests {

// Per set: pairs by distance from 0.9 r to 4.5 r, or nearest neighbours from 0.9 r to 2.1 r, in
// equal bins, as shares of the number of points.
std::vector<double> pair_histogram(const Plan& plan, const std::vector<Sample>& samples);
std::vector<double> nearest_histogram(const Plan& plan, const std::vector<Sample>& samples);

struct Comparison {
    double largest_z = 0;  // of any entry: difference of the means over its standard error
    double sum_z_squared = 0;
    int entries = 0;  // that vary at all
    // No entry beyond what one chance in a thousand allows for so many entries, and the sum of
    // squares below five of its own standard deviations (the entries of one set correlate, which
    // widens it).
    bool agree() const;
    std::string text() const;
};

// Each group is a list of vectors of one length, a vector a set.
Comparison compare(const std::vector<std::vector<double>>& a,
                   const std::vector<std::vector<double>>& b);

}  // namespace lacuna::tests
