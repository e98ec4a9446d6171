// What a conflict metric does along the edge of a step in importance: figures 2 and 6 as a number.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>

#include "reproduce/sets.h"

namespace lacuna::reproduce {

// Importance 1 on the left half of a torus of 2 x 1, 1/10 on the right: two edges of length 1.
struct Step {
    double dense_radius = 0.012;
    std::uint32_t m = 10;
};

// A mean over sets, with its standard error.
struct Mean {
    double value;
    double error;  // 0 for one set
};

// Samples that the dense side lacks within one of its radii of the edge, against its density far
// from the edge, per radius of edge. Below 0: that it has too many.
Mean missing_along_edge(const Step& step, Metric metric, std::uint32_t runs, Work& work);

}  // namespace lacuna::reproduce
