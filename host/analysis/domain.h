// Types that all analyses use: the domain, and the callback for progress.
#pragma once

#include <functional>

#include "verify/domain.h"

namespace lacuna::analysis {

// On a torus distances wrap. The frequencies are the rectangle's, on a torus and on a box.
using Domain = verify::Domain;

// Called on the calling thread with the finished fraction of the work, from 0 to 1. If it returns
// false, the work ends with lacuna::Cancelled.
using KeepGoing = std::function<bool(double share)>;

}  // namespace lacuna::analysis
