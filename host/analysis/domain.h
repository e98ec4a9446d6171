// What every analysis is told of a point set beside its points, and how it is watched.
#pragma once

#include <functional>

#include "verify/domain.h"

namespace lacuna::analysis {

// Distances wrap where it is a torus. Frequencies are those of the rectangle in both cases.
using Domain = verify::Domain;

// Told on the calling thread how much of the work is done, from 0 to 1. When it says false the
// work ends with lacuna::Cancelled.
using KeepGoing = std::function<bool(double share)>;

}  // namespace lacuna::analysis
