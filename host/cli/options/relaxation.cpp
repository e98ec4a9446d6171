// Relaxing points under a progress bar.
#include "cli/options/relaxation.h"

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/reports/report.h"
#include "cli/terminal/driver.h"
#include "cli/terminal/observers.h"
#include "cli/terminal/progress_bar.h"
#include "files/formats.h"
#include "verify/closest.h"

namespace lacuna::cli {
namespace {

// Notes that the points of `made` were moved: the set is not known to be maximal, and its radius
// becomes the least distance if a report or a .json needs it, and otherwise 0, which means not
// known. Returns the least distance if it is known.
std::optional<double> measure_moved(const CommonOptions& common, const std::vector<Output>& outputs,
                                    const Domain& domain, Made& made) {
    made.result.maximal = false;
    made.result.radius = 0;
    const bool is_told = !common.report.empty() ||
                         std::any_of(outputs.begin(), outputs.end(), [](const Output& output) {
                             return output.format.name() == "json";
                         });
    if (!is_told || made.result.points.size() < 2) return std::nullopt;
    made.result.radius =
        verify::closest_pair(verify::domain_of(domain), made.result.points).distance;
    return made.result.radius;
}

}  // namespace

Relaxation relax_points(const CommonOptions& common, const std::vector<Output>& outputs,
                        const RelaxOptions& options, const Field* field, Made& made) {
    Relaxation relaxation{options, {}, std::nullopt};
    relaxation.options.measure = !common.report.empty();
    {
        ProgressBar bar(common.quiet);
        DriverAtWork driver(options.place.backend);
        Observers observers({driver, made.stopwatch, bar});
        relaxation.relaxed = relax(made.result.points, field, relaxation.options, observers);
    }
    made.seconds = made.stopwatch.seconds_so_far();
    made.result.points = std::move(relaxation.relaxed.points);
    made.result.backend = relaxation.relaxed.backend;  // a stratified start has none
    made.result.device = relaxation.relaxed.device;
    relaxation.least_distance = measure_moved(common, outputs, options.domain, made);
    return relaxation;
}

nlohmann::ordered_json json_of_moves(const RelaxOptions& options) {
    Json json{{"relax", options.iterations}};
    if (options.gaussian != 0)
        json.update(
            {{"gaussian", options.gaussian}, {"gaussian_distance", options.gaussian_distance}});
    return json;
}

nlohmann::ordered_json json_of(const Relaxation& relaxation) {
    const Relaxed& relaxed = relaxation.relaxed;
    Json json{{"lattice", {relaxed.lattice_columns, relaxed.lattice_rows}}};
    if (relaxed.evenness)
        json["capacity_cv"] = {{"before", relaxed.evenness->before},
                               {"after", relaxed.evenness->after},
                               {"after_in_voronoi_cells", relaxed.evenness->after_voronoi}};
    json["least_distance"] =
        relaxation.least_distance ? Json(*relaxation.least_distance) : Json(nullptr);
    json["backend"] = relaxed.backend;
    json["device"] = relaxed.device;
    return {{"request", json_of_moves(relaxation.options)}, {"relax", json}};
}

}  // namespace lacuna::cli
