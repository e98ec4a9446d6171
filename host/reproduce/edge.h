// The effect of a conflict metric along a step in importance: figures 2 and 6 as a number.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>

#include "reproduce/sets.h"

namespace lacuna::reproduce {

// A torus of 2 x 1 with importance 1 on the left half and 1/10 on the right: two edges of length 1.
struct Step {
    double dense_radius = 0.012;
    std::uint32_t m = 10;
};

// A mean over several sets, and its standard error.
struct Mean {
    double value;
    double error;  // 0 for one set
};

// The number of samples that are missing near the edge: on its dense side, up to one dense radius
// away, compared to the density far from it, per dense radius of its length. Negative: too many.
Mean missing_along_edge(const Step& step, Metric metric, std::uint32_t runs, Work& work);

}  // namespace lacuna::reproduce
