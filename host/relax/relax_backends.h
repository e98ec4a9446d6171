// The backends for relaxation, and the choice among them.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "relax/gaussian_backend.h"
#include "relax/relax_backend.h"

namespace lacuna::relaxing {

struct Chosen {
    std::string name;
    std::unique_ptr<RelaxBackend> backend;
};

// The backend that Place::backend names; "auto" means LACUNA_BACKEND of the environment, otherwise
// cpu. The lattice must outlive the backend. Throws BadRequest and Unavailable.
Chosen make_relax_backend(const RunOn& run_on, const Lattice& lattice, std::span<const Site> sites,
                          const Poll& poll = nobody_asks);

// The same backend for the descent of the Gaussian energy. The field must outlive it.
struct ChosenForGaussian {
    std::string name;
    std::unique_ptr<GaussianBackend> backend;
};
ChosenForGaussian make_gaussian_backend(const RunOn& run_on, const GaussianField& field,
                                        std::span<const Spot> spots,
                                        const Poll& poll = nobody_asks);

}  // namespace lacuna::relaxing
