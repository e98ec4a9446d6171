// Samples meshes and volumes, and writes their sets.
#include "cli/commands/sample_space.h"

#include <fmt/core.h>
#include <lacuna/domains.h>
#include <lacuna/version.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "cli/options/sample_seeds.h"
#include "cli/reports/report.h"
#include "cli/terminal/interruption.h"
#include "drawing/space.h"
#include "files/read_points.h"

namespace lacuna::cli {
namespace {

// What decides which points are made.
Json asked_in_space(const SpaceRequest& request, const options::InSpace& space,
                    const std::string& keep, const SpaceResult& result) {
    Json json = Json::object();
    if (space.volume)
        json = {{"width", request.volume.width},
                {"height", request.volume.height},
                {"depth", request.volume.depth},
                {"boundary", request.volume.boundary == Boundary::torus ? "torus" : "box"}};
    else
        json["on"] = space.mesh;
    json.update({{"radius", or_null(request.radius)},
                 {"count", or_null(request.count)},
                 {"limit", or_null(request.limit)},
                 {"round_size", request.round_size},
                 {"seed", request.seed}});
    if (!keep.empty())
        json.update(
            {{"keep", keep}, {"kept", std::min(request.keep.size(), result.points.size())}});
    return json;
}

files::Origin origin_in_space(const CommandLine& line, const SpaceRequest& request,
                              const SpaceResult& result, const Json& decides) {
    // File names are bytes, which need not be UTF-8.
    return {.version = LACUNA_VERSION,
            .command = line.text(request.seed),
            .mode = Mode::exact,
            .seed = request.seed,
            .maximal = result.maximal,
            .options = decides.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

std::string words_in_space(const SpaceRequest& request, const options::InSpace& space,
                           const SpaceResult& result, double seconds) {
    std::string note = space.volume ? "" : " on " + space.mesh;
    if (!request.keep.empty())
        note +=
            fmt::format(", {} of them kept", std::min(request.keep.size(), result.points.size()));
    if (!request.radius) note += fmt::format(", radius {:.4g}", result.radius);
    if (!result.maximal) note += ", not maximal";
    return words_of(result.points.size(), "point", result.rounds, note, seconds, result.backend);
}

}  // namespace

void sample_in_space(const CommandLine& line, const CommonOptions& options,
                     const options::InSpace& space, const std::string& keep) {
    options::refuse_options_of_plane(line, space);
    refuse_seed_in(options.output.paths, options.report);
    const std::vector<Output> outputs = checked_outputs(options, files_read(line));
    for (const Output& output : outputs) files::check_in_space(output.format, output.path);
    const Mesh mesh = space.mesh.empty() ? Mesh() : read_mesh(space.mesh);
    std::vector<Point3> kept;
    if (!keep.empty()) kept = files::read_points(keep, files::Lie::in_space).in_space();
    SpaceRequest request = options::request_of(space);
    if (!space.volume) request.mesh = &mesh;
    request.keep = kept;
    Interruption interruption;
    Finished made{.stopwatch = Stopwatch(!options.report.empty())};
    const auto sample_it = [&](Observer& observer) {
        return space.volume ? sample_volume(request, observer) : sample_surface(request, observer);
    };
    const SpaceResult result =
        naming_mesh(space, [&] { return watched(options, made, sample_it); });
    const std::vector<Point3> normals =
        space.volume ? std::vector<Point3>() : normals_of(mesh, result.triangles);
    const Json decides = asked_in_space(request, space, keep, result);
    const files::Origin origin = origin_in_space(line, request, result, decides);
    const files::SetInSpace set{.points = result.points,
                                .radius = result.radius,
                                .origin = &origin,
                                .mesh = request.mesh,
                                .volume = space.volume ? &request.volume : nullptr,
                                .triangles = result.triangles,
                                .normals = normals};
    Json asked = decides;
    asked.update({{"backend", request.run_on.backend}, {"threads", request.run_on.threads}});
    Writing writing(interruption);
    if (!options.report.empty())
        writing.add(options.report, [&] { return report_of(asked, result, made); });
    for (const Output& output : outputs)
        writing.add(output.path, [&] { return drawing::encode(set, output.format); });
    writing.write();
    sum_up({outputs, options.report, options.quiet},
           words_in_space(request, space, result, made.seconds), result.points.empty());
}

}  // namespace lacuna::cli
