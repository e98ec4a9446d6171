// Takes claims in space from options and files, and proves them.
#include "cli/commands/verify_space.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/number_text.h"
#include "cli/commands/sample_space.h"
#include "cli/terminal/run_program.h"

namespace lacuna::cli {
namespace {

// Options come first, then what a .json says.
SpaceSetClaim claim_in_space(const SpaceClaimOptions& options, const Mesh& mesh,
                             const files::PointsOfFile& file, const std::string& name) {
    SpaceSetClaim claim;
    const SpaceRequest asked = options::request_of(options.space);
    claim.name = name;
    if (file.z.size() != file.points.size())
        throw files::FileError(name + ": has two coordinates for each point, and is not in space");
    claim.points = file.in_space();
    claim.volume = asked.volume;
    const auto on = file.origin.values.find("on");
    if (!options.space.mesh.empty()) {
        claim.mesh = &mesh;
        claim.mesh_name = options.space.mesh;
    } else if (!options.space.volume && on != file.origin.values.end()) {
        throw BadUsage(
            fmt::format("{}: made with --on {}: give that too", name, shown(on->second)));
    } else if (!options.space.volume && file.domain && file.depth) {
        claim.volume = {file.domain->width, file.domain->height, *file.depth,
                        asked.volume.boundary};
    }
    if (file.boundary == Boundary::torus) claim.volume.boundary = Boundary::torus;
    const std::optional<double> radius = asked.radius ? asked.radius : file.radius;
    if (!radius)
        throw BadRequest("radius", "missing",
                         "give the radius that the points should have, or a .json that holds it");
    claim.radius = *radius;
    claim.tolerance = options.tolerance;
    claim.distances_only = options.distances_only;
    claim.meant_to_be_maximal = file.origin.maximal.value_or(true);
    return claim;
}

}  // namespace

std::vector<SpaceSetClaim> proven_in_space(const CommandLine& line,
                                           const SpaceClaimOptions& options, const Mesh& mesh,
                                           const std::vector<std::string>& names,
                                           const std::vector<files::PointsOfFile>& files) {
    options::refuse_options_of_plane(line, options.space);
    std::vector<Point3> kept;
    if (!options.keep.empty())
        kept = files::read_points(options.keep, files::Lie::in_space).in_space();
    std::vector<SpaceSetClaim> claims;
    for (std::size_t i = 0; i < files.size(); ++i)
        claims.push_back(claim_in_space(options, mesh, files[i], names[i]));
    for (SpaceSetClaim& claim : claims) {
        claim.proof = naming_mesh(options.space, [&] { return prove(claim.points, claim); });
        claim.keep = options.keep;
        const auto [own, other] =
            std::mismatch(claim.points.begin(), claim.points.end(), kept.begin(), kept.end());
        if (other != kept.end()) claim.moved = static_cast<std::size_t>(other - kept.begin());
    }
    return claims;
}

}  // namespace lacuna::cli
