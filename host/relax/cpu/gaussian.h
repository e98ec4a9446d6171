// The descent of the Gaussian energy on threads.
#pragma once

#include <memory>
#include <span>

#include "backends/backend.h"
#include "relax/cpu/pulls.h"
#include "relax/gaussian_backend.h"

namespace lacuna::relaxing::cpu {

// The field must outlive the backend.
std::unique_ptr<GaussianBackend> make_gaussian_backend(const GaussianField& field,
                                                       std::span<const Spot> spots,
                                                       const Placement& placement, const Poll&);

// For tests: with one of all_pullers().
std::unique_ptr<GaussianBackend> make_gaussian_backend(const GaussianField& field,
                                                       std::span<const Spot> spots,
                                                       const Placement& placement,
                                                       const Puller& puller);

}  // namespace lacuna::relaxing::cpu
