// Relaxing points under a progress bar.
#include "cli/options/relaxation.h"

#include <lacuna/verify.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/reports/report.h"
#include "files/formats.h"

namespace lacuna::cli {
bool says_distances(const CommonOptions& common, const std::vector<Output>& outputs) {
    return !common.report.empty() ||
           std::any_of(outputs.begin(), outputs.end(),
                       [](const Output& output) { return output.format.name() == "json"; });
}

Relaxation relax_points(const CommonOptions& common, const std::vector<Output>& outputs,
                        const RelaxOptions& options, const Field* field, Finished& made) {
    Relaxation relaxation{options, {}, std::nullopt};
    relaxation.options.measure = !common.report.empty();
    relaxation.relaxed = watched(common, made, [&](Observer& observer) {
        return relax(made.result.points, field, relaxation.options, observer);
    });
    made.result.points = std::move(relaxation.relaxed.points);
    made.result.backend = relaxation.relaxed.backend;  // a stratified start has none
    made.result.device = relaxation.relaxed.device;
    if (says_distances(common, outputs) && made.result.points.size() > 1)
        made.result.radius =
            relaxation.least_distance.emplace(least_distance(made.result.points, options.domain));
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
