// The backends that relax points, and the choice among them.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "relax/relax_backend.h"

namespace lacuna::relaxing {

struct Chosen {
    std::string name;
    std::unique_ptr<RelaxBackend> backend;
};

// As options.backend says, or the environment's LACUNA_BACKEND where that is "auto". The lattice
// must outlive the backend. Throws BadRequest and Unavailable.
Chosen make_relax_backend(const RelaxOptions& options, const Lattice& lattice,
                          std::span<const Site> sites, const Poll& poll = nobody_asks);

}  // namespace lacuna::relaxing
