// Relaxes points under a progress bar, for `lacuna relax` and for --relax of sample and stipple.
#pragma once

#include <lacuna/inks.h>
#include <lacuna/lacuna.h>

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/app_fwd.h"
#include "cli/options/common_options.h"
#include "cli/reports/output.h"

namespace lacuna::cli {

// Adds --relax, whose help names this default.
void add_relax(CLI::App& command, std::optional<std::uint32_t>& iterations,
               std::uint32_t usual_iterations);

// The steps on the Gaussian energy that follow the iterations.
struct GaussianOptions {
    std::uint32_t steps = 0;
    std::optional<double> distance{};
};
// Adds --gaussian and --gaussian-distance.
void add_gaussian(CLI::App& command, GaussianOptions& gaussian);

// The results of relaxing, besides the points.
struct Relaxation {
    RelaxOptions options;
    Relaxed relaxed;  // without its points
    std::optional<double> least_distance;
};

// Options with the request's domain, backend, device and threads.
RelaxOptions relax_options_of(const Request& request, std::uint32_t iterations,
                              const GaussianOptions& gaussian = {});

// Notes that points of `made` were moved: the set is not known to be maximal, and its radius
// becomes the least distance if a report or a .json needs it, and otherwise 0, which means not
// known. Returns the least distance if it is known.
std::optional<double> measure_moved(const CommonOptions& common, const std::vector<Output>& outputs,
                                    const RelaxOptions& domain, Made& made);

// Relaxes the points of `made` under a progress bar, and adds the time to it; `field` may be null.
// Evenness is measured if there is a report. Calls measure_moved(). Throws what lacuna::relax
// throws.
Relaxation relax_points(const CommonOptions& common, const std::vector<Output>& outputs,
                        const RelaxOptions& options, const Field* field, Made& made);

// Places the dots of several inks and relaxes them, as relax_points() does.
Relaxation place_inks(const CommonOptions& common, const std::vector<Output>& outputs,
                      std::span<const InkPart> inks, const RelaxOptions& options, Made& made);

// What decides how points are moved: the numbers of iterations and of steps.
nlohmann::ordered_json json_of_moves(const RelaxOptions& options);
// For a report: {"relax": {...}}, and in "request" what decides how points are moved.
nlohmann::ordered_json json_of(const Relaxation& relaxation);

}  // namespace lacuna::cli
