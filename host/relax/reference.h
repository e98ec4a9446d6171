// Relaxation written to be read, never to be fast: every lattice point tries every site.
#pragma once

#include <memory>
#include <span>

#include "backends/backend.h"
#include "relax/relax_backend.h"

namespace lacuna::relaxing::reference {

// The lattice must outlive the backend.
std::unique_ptr<RelaxBackend> make_backend(const Lattice& lattice, std::span<const Site> sites,
                                           const Placement& placement, const Poll& poll);

}  // namespace lacuna::relaxing::reference
