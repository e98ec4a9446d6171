// The functions of lacuna.h for sets in space.
#include <lacuna.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "c/calls.h"
#include "options/read_text.h"
#include "options/space.h"

namespace lacuna {
namespace {

using c::error_of_thread;

std::vector<Point3> points_in_space(const char* name, const double* xyz, std::size_t count) {
    if (xyz == nullptr && count != 0)
        throw BadRequest(name, "NULL", "must be " + std::to_string(count) + " points");
    std::vector<Point3> points;
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i, xyz += 3) points.push_back({xyz[0], xyz[1], xyz[2]});
    return points;
}

Mesh mesh_of(const lacuna_mesh& given) {
    Mesh mesh{.vertices = points_in_space("vertices", given.vertices, given.vertex_count)};
    if (given.triangles == nullptr && given.triangle_count != 0)
        throw BadRequest("triangles", "NULL",
                         "must be " + std::to_string(given.triangle_count) + " triangles");
    const unsigned* from = given.triangles;
    for (std::size_t i = 0; i < given.triangle_count; ++i, from += 3)
        mesh.triangles.push_back({from[0], from[1], from[2]});
    return mesh;
}

// What a text of options asks for on a mesh or, without one, in a volume.
class Asked {
public:
    Asked(options::Commands command, const char* text, const lacuna_mesh* given) {
        options::Targets targets = options::targets_of(space);
        targets.merge(options::targets_of(plane_));
        targets["tolerance"] = &tolerance;
        targets["distances-only"] = &distances_only;
        targets.erase("on");
        const options::CommandLine line = options::read_text(command, text, targets);
        if (given != nullptr) {
            space.mesh = "the mesh";
            mesh = mesh_of(*given);
        }
        options::refuse_options_of_plane(line, space);
        if (given == nullptr && !space.volume) space.volume.emplace();
    }

private:
    Request plane_;

public:
    options::InSpace space{plane_};
    Mesh mesh;
    std::optional<double> tolerance;
    bool distances_only = false;
};

lacuna_set* sampled_in_space(const char* options, const lacuna_mesh* mesh, const double* kept,
                             std::size_t kept_count) {
    const Asked asked(options::kSample, options, mesh);
    SpaceRequest request = options::request_of(asked.space);
    if (mesh != nullptr) request.mesh = &asked.mesh;
    if (mesh != nullptr && mesh->allowed != nullptr)
        request.allowed = {mesh->allowed, mesh->triangle_count};
    const std::vector<Point3> all_kept = points_in_space("keep", kept, kept_count);
    request.keep = all_kept;
    c::Watched observer;
    SpaceResult result =
        mesh != nullptr ? sample_surface(request, observer) : sample_volume(request, observer);
    auto set = std::make_unique<lacuna_set>();
    set->in_space = std::move(result.points);
    set->triangles.assign(result.triangles.begin(), result.triangles.end());
    set->facts.radius = result.radius;
    set->facts.maximal = result.maximal ? 1 : 0;
    if (mesh == nullptr) {
        set->facts.width = request.volume.width;
        set->facts.height = request.volume.height;
        set->facts.depth = request.volume.depth;
    }
    return set.release();
}

// What the set lacks; empty if it is as claimed.
std::string lack_of(const SpaceProof& proof, const SpaceClaim& claim) {
    if (proof.outside)
        return "point " + std::to_string(*proof.outside) + ", numbered from 0, lies " +
               (claim.mesh != nullptr ? "off the mesh" : "outside of the volume");
    if (!proof.kept)
        return "points " + std::to_string(proof.first) + " and " + std::to_string(proof.second) +
               ", numbered from 0, are " + shortest(proof.least_distance) + " apart, less than " +
               shortest(claim.radius);
    if (claim.distances_only || proof.maximal) return "";
    if (proof.covered)
        return "not proven maximal, as the tolerance is over 1 % of the radius: " +
               shortest(proof.tolerance);
    const auto& [x, y, z] = proof.largest_gap;
    return "there is room for a point at (" + shortest(x) + ", " + shortest(y) + ", " +
           shortest(z) + "), " + shortest(proof.largest_gap_distance) + " from the nearest one";
}

int verified_in_space(const char* options, const lacuna_mesh* mesh, const double* points,
                      std::size_t count) {
    const Asked asked(options::kVerify, options, mesh);
    const SpaceRequest request = options::request_of(asked.space);
    if (!request.radius)
        throw BadRequest("radius", "missing", "give the distance that points should keep");
    const SpaceClaim claim{.mesh = mesh != nullptr ? &asked.mesh : nullptr,
                           .volume = request.volume,
                           .radius = *request.radius,
                           .tolerance = asked.tolerance,
                           .distances_only = asked.distances_only};
    c::Watched observer;
    const SpaceProof proof = prove(points_in_space("points", points, count), claim, [&] {
        return observer.keep_going({0, 1, 0});
    });
    error_of_thread = lack_of(proof, claim);
    return error_of_thread.empty() ? 1 : 0;
}

}  // namespace
}  // namespace lacuna

lacuna_set* lacuna_sample_surface(const char* options, const lacuna_mesh* mesh, const double* kept,
                                  size_t kept_count) {
    return lacuna::c::guarded(static_cast<lacuna_set*>(nullptr), [&] {
        if (mesh == nullptr)
            throw lacuna::BadRequest("mesh", "NULL", "give one, or call lacuna_sample_volume()");
        return lacuna::sampled_in_space(options, mesh, kept, kept_count);
    });
}

lacuna_set* lacuna_sample_volume(const char* options, const double* kept, size_t kept_count) {
    return lacuna::c::guarded(static_cast<lacuna_set*>(nullptr), [&] {
        return lacuna::options::naming_domain(
            [&] { return lacuna::sampled_in_space(options, nullptr, kept, kept_count); });
    });
}

int lacuna_verify_in_space(const char* options, const lacuna_mesh* mesh, const double* points,
                           size_t count) {
    return lacuna::c::guarded(-1, [&] {
        return lacuna::options::naming_domain(
            [&] { return lacuna::verified_in_space(options, mesh, points, count); });
    });
}

const unsigned* lacuna_triangles(const lacuna_set* set) {
    return set == nullptr || set->triangles.empty() ? nullptr : set->triangles.data();
}
