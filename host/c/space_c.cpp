// The functions of lacuna.h for sets in space.
#include <lacuna.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "c/calls.h"
#include "options/read_text.h"
#include "options/space.h"

namespace lacuna {
namespace {

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

lacuna_set* sampled_in_space(const char* options, const lacuna_mesh* mesh, const double* kept,
                             std::size_t kept_count) {
    Request plane;
    options::InSpace space{plane};
    options::Targets targets = options::targets_of(space);
    targets.merge(options::targets_of(plane));
    targets.erase("on");
    const options::CommandLine line = options::read_text(options::kSample, options, targets);
    if (mesh != nullptr) space.mesh = "the mesh";
    options::refuse_options_of_plane(line, space);
    SpaceRequest request = options::request_of(space);
    const Mesh surface = mesh != nullptr ? mesh_of(*mesh) : Mesh();
    if (mesh != nullptr) request.mesh = &surface;
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
        return lacuna::sampled_in_space(options, nullptr, kept, kept_count);
    });
}

const unsigned* lacuna_triangles(const lacuna_set* set) {
    return set == nullptr || set->triangles.empty() ? nullptr : set->triangles.data();
}
