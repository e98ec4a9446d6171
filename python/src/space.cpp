// Surfaces and volumes: sampling and proving.
#include <lacuna/space.h>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "arrays.h"
#include "options.h"
#include "parts.h"
#include "watch.h"

namespace nb = nanobind;

namespace lacuna::python {
namespace {

static_assert(sizeof(Point3) == 3 * sizeof(double), "points are rows of three numbers");
using Rows = nb::ndarray<const double, nb::numpy, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using Triangles =
    nb::ndarray<const std::uint32_t, nb::numpy, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;

std::vector<Point3> points_of_rows(const Rows& array) {
    std::vector<Point3> points(array.shape(0));
    const double* from = array.data();
    for (Point3& point : points) {
        point = {from[0], from[1], from[2]};
        from += 3;
    }
    return points;
}

// Needs the GIL until it is made. The mesh is there after copy(), which does not.
class GivenMesh {
public:
    GivenMesh(std::optional<Rows> vertices, std::optional<Triangles> faces)
        : vertices_(std::move(vertices)), faces_(std::move(faces)) {}

    const Mesh* copy() {
        if (!vertices_ || !faces_) return nullptr;
        mesh_.vertices = points_of_rows(*vertices_);
        mesh_.triangles.resize(faces_->shape(0));
        const std::uint32_t* from = faces_->data();
        for (auto& triangle : mesh_.triangles) {
            triangle = {from[0], from[1], from[2]};
            from += 3;
        }
        return &mesh_;
    }
    const Mesh& mesh() const { return mesh_; }

private:
    std::optional<Rows> vertices_;
    std::optional<Triangles> faces_;
    Mesh mesh_;
};

Volume volume_in(const nb::dict& given) {
    std::array<double, 3> sides{1, 1, 1};
    bool torus = false;
    read(given, "volume", sides);
    read(given, "torus", torus);
    return {sides[0], sides[1], sides[2], torus ? Boundary::torus : Boundary::box};
}

// Returns the attributes of a SpaceSet.
nb::dict sample_in_space(const nb::dict& given, std::optional<Rows> vertices,
                         std::optional<Triangles> faces, const std::optional<ClassArray>& allowed,
                         const std::optional<Rows>& keep, nb::object progress) {
    SpaceRequest request{.volume = volume_in(given), .run_on = run_on_in(given)};
    read(given, "radius", request.radius);
    read(given, "n", request.count);
    read(given, "limit", request.limit);
    read(given, "seed", request.seed);
    read(given, "round_size", request.round_size);
    GivenMesh mesh(std::move(vertices), std::move(faces));
    Watch watch(std::move(progress));
    SpaceResult set;
    std::vector<Point3> kept, normals;
    std::vector<std::uint8_t> allowed_copy;
    {
        const nb::gil_scoped_release no_gil;
        request.mesh = mesh.copy();
        if (keep) kept = points_of_rows(*keep);
        if (allowed) allowed_copy = classes_of(*allowed);
        request.keep = kept;
        request.allowed = allowed_copy;
        set = request.mesh != nullptr ? sample_surface(request, watch)
                                      : sample_volume(request, watch);
        if (request.mesh != nullptr) normals = normals_of(mesh.mesh(), set.triangles);
    }
    nb::dict made;
    made["points"] = array_of(std::move(set.points));
    made["radius"] = set.radius;
    made["maximal"] = set.maximal;
    made["triangles"] = made["shares"] = made["normals"] = nb::none();
    if (request.mesh != nullptr) {
        made["triangles"] = array_of(std::move(set.triangles));
        made["shares"] = array_of(std::move(set.shares));
        made["normals"] = array_of(std::move(normals));
    }
    made["seed"] = request.seed;
    made["rounds"] = set.rounds;
    made["draws"] = set.draws;
    made["backend"] = set.backend;
    made["device"] = set.device;
    made["seconds"] = watch.seconds();
    return made;
}

// Returns the attributes of a SpaceVerdict.
nb::dict verify_in_space(const Rows& points, const nb::dict& given, std::optional<Rows> vertices,
                         std::optional<Triangles> faces) {
    SpaceClaim claim{.volume = volume_in(given)};
    read(given, "radius", claim.radius);
    read(given, "tolerance", claim.tolerance);
    read(given, "distances_only", claim.distances_only);
    GivenMesh mesh(std::move(vertices), std::move(faces));
    Watch watch{nb::none()};
    SpaceProof proof;
    {
        const nb::gil_scoped_release no_gil;
        claim.mesh = mesh.copy();
        proof = prove(points_of_rows(points), claim, [&] {
            watch.look(0, 0);
            return true;
        });
    }
    nb::dict found;
    const bool is_known = !proof.outside;
    const bool has_pair = is_known && std::isfinite(proof.least_distance);
    const bool has_gap =
        is_known && !claim.distances_only && std::isfinite(proof.largest_gap_distance);
    found["holds"] = is_known && proof.kept && (claim.distances_only || proof.covered);
    found["maximal"] = proof.maximal;
    found["outside"] = nb::none();
    if (proof.outside) found["outside"] = *proof.outside;
    found["closest_pair"] = nb::none();
    if (has_pair) found["closest_pair"] = nb::make_tuple(proof.first, proof.second);
    found["least_distance"] = proof.least_distance;
    found["largest_gap"] = nb::none();
    if (has_gap)
        found["largest_gap"] =
            nb::make_tuple(proof.largest_gap.x, proof.largest_gap.y, proof.largest_gap.z);
    found["largest_gap_distance"] = proof.largest_gap_distance;
    found["tolerance"] = proof.tolerance;
    return found;
}

}  // namespace

void add_space(nb::module_& module) {
    module.def("sample_in_space", sample_in_space, nb::arg(), nb::arg().none(), nb::arg().none(),
               nb::arg().none(), nb::arg().none(), nb::arg().none());
    module.def("verify_in_space", verify_in_space, nb::arg(), nb::arg(), nb::arg().none(),
               nb::arg().none());
}

}  // namespace lacuna::python
