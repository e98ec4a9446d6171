// The descent of the Gaussian energy on the reference.
#pragma once

#include <memory>
#include <span>

#include "backends/backend.h"
#include "relax/gaussian_backend.h"

namespace lacuna::relaxing::reference {

// The field must outlive the backend.
std::unique_ptr<GaussianBackend> make_gaussian_backend(const GaussianField& field,
                                                       std::span<const Spot> spots,
                                                       const Placement&, const Poll&);

}  // namespace lacuna::relaxing::reference
