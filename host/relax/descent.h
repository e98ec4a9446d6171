// The steps of RelaxOptions::gaussian, on the backend that was asked for.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "relax/gaussian.h"

namespace lacuna::relaxing {

// Throws BadRequest if there can be no such steps on a domain with this importance, or none.
void check_gaussian(const Field* importance, const RelaxOptions& options);

// The field for so many points, at least one; nothing if there are no steps. Checks the options.
// Throws BadRequest.
std::optional<GaussianField> checked_gaussian(std::size_t points, const Field* importance,
                                              const RelaxOptions& options);

// Takes the steps with the points, and sets backend and device. Progress counts on from the
// iterations of `options`. Throws what relax throws.
void descend(Relaxed& relaxed, const GaussianField& field, const RelaxOptions& options,
             Observer& observer);

}  // namespace lacuna::relaxing
