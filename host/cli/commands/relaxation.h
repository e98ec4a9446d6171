// Relaxing points under a progress bar: what `lacuna relax` does, and sample and stipple with
// --relax.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/app_fwd.h"
#include "cli/options/common_options.h"
#include "cli/reports/output.h"

namespace lacuna::cli {

// --relax, whose default the help names.
void add_relax(CLI::App& command, std::uint32_t& iterations);

// What came of it, beside points.
struct Relaxation {
    std::uint32_t iterations = 0;
    Relaxed relaxed;  // its points have been taken
    std::optional<double> least_distance;
};

// Where points are relaxed as the request says; `field` may be null.
RelaxOptions relax_options_of(const Request& request, std::uint32_t iterations);

// Relaxes the points of `made` under a progress bar, and takes its time too. Evenness is measured
// for a report; the radius becomes the least distance where a report or a .json needs it, and 0,
// not known, elsewhere. Throws what lacuna::relax throws.
Relaxation relax_points(const CommonOptions& common, const std::vector<Output>& outputs,
                        const RelaxOptions& options, const Field* field, Made& made);

// For a report: {"relax": {...}}, and the request's iterations.
nlohmann::ordered_json json_of(const Relaxation& relaxation);

}  // namespace lacuna::cli
