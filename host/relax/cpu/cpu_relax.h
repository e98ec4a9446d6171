// Relaxation on threads.
#pragma once

#include <memory>
#include <span>

#include "backends/backend.h"
#include "relax/relax_backend.h"

namespace lacuna::relaxing::cpu {

// The lattice must outlive the backend.
std::unique_ptr<RelaxBackend> make_backend(const Lattice& lattice, std::span<const Site> sites,
                                           const Placement& placement, const Poll& poll);

}  // namespace lacuna::relaxing::cpu
