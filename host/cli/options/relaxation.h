// Relaxes points under a progress bar, for `lacuna relax`; and what reports say of relaxing.
#pragma once

#include <lacuna/lacuna.h>

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/common_options.h"
#include "cli/reports/output.h"
#include "options/make.h"

namespace lacuna::cli {

// The results of relaxing, besides the points.
struct Relaxation {
    RelaxOptions options;
    Relaxed relaxed;  // without its points
    std::optional<double> least_distance;
};

// Whether a report or a .json says the least distance of moved points. It is not looked for or said
// otherwise: a radius of 0 means that it is not known.
bool says_distances(const CommonOptions& common, const std::vector<Output>& outputs);

// Relaxes the points of `made` under a progress bar, and adds the time to it; `field` may be null.
// Evenness is measured if there is a report. The set is then not known to be maximal; its radius is
// the least distance if a report or a .json needs it, and otherwise 0, which means not known.
// Throws what lacuna::relax throws.
Relaxation relax_points(const CommonOptions& common, const std::vector<Output>& outputs,
                        const RelaxOptions& options, const Field* field, Finished& made);

// What decides how points are moved: the numbers of iterations and of steps.
nlohmann::ordered_json json_of_moves(const RelaxOptions& options);
// For a report: {"relax": {...}}, and in "request" what decides how points are moved.
nlohmann::ordered_json json_of(const Relaxation& relaxation);

}  // namespace lacuna::cli
