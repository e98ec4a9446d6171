// The functions verify and analyze.
#include <lacuna/analysis.h>
#include <lacuna/verify.h>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "arrays.h"
#include "background.h"
#include "parts.h"
#include "polygon_sets.h"
#include "watch.h"

namespace nb = nanobind;

namespace lacuna::python {
namespace {

// Fewer points than this are verified too fast for Ctrl-C to matter, so no thread is started.
constexpr std::size_t kFewPoints = 10000;

Boundary boundary_of(bool torus) {
    return torus ? Boundary::torus : Boundary::box;
}

template <typename Number>
nb::object or_none(const std::optional<Number>& number) {
    return number ? nb::cast(*number) : nb::none();
}

// The name that python/lacuna has for the reason why no point may lie at a spot.
const char* name_of(Proof::Closed closed) {
    switch (closed) {
        case Proof::Closed::importance:
            return "field";
        case Proof::Closed::mask:
            return "mask";
        case Proof::Closed::polygons:
            return "inside";
        case Proof::Closed::border:
            return "border";
    }
    return "";
}

nb::dict verify_points(const PointArray& array, const Claim& asked, const Field* field,
                       const Mask* mask, const nb::list& polygons,
                       const std::optional<PointArray>& keep,
                       const std::optional<ClassArray>& class_of) {
    PolygonSets sets(polygons);
    const auto work = [&](const std::atomic<bool>& stop) {
        const std::vector<Point> kept = keep ? points_of(*keep) : std::vector<Point>{};
        Claim claim = asked;
        claim.field = field;
        claim.mask = mask;
        claim.polygons = sets.copy();
        claim.keep = kept;
        const std::vector<std::uint8_t> of_points =
            class_of ? classes_of(*class_of) : std::vector<std::uint8_t>{};
        claim.class_of_points = of_points;
        return prove(points_of(array), claim, [&] { return !stop; });
    };
    Proof proof;
    if (array.shape(0) < kFewPoints) {
        const std::atomic<bool> never = false;
        const nb::gil_scoped_release no_gil;
        proof = work(never);
    } else {
        proof = in_background(work);
    }
    nb::dict found;
    found["outside"] = or_none(proof.outside);
    found["moved"] = or_none(proof.moved);
    found["forbidden"] = or_none(proof.forbidden);
    found["forbidden_by"] =
        proof.forbidden ? nb::cast(name_of(proof.forbidden_by)) : nb::object(nb::none());
    found["kept"] = proof.kept;
    found["first"] = proof.first;
    found["second"] = proof.second;
    found["least_distance"] = proof.least_distance;
    found["least_limit"] = proof.least_limit;
    found["covered"] = proof.covered;
    found["largest_gap"] = nb::make_tuple(proof.largest_gap.x, proof.largest_gap.y);
    found["largest_gap_distance"] = proof.largest_gap_distance;
    found["largest_gap_limit"] = proof.largest_gap_limit;
    found["largest_gap_class"] = proof.largest_gap_class;
    found["tolerance"] = proof.tolerance;
    found["maximal"] = proof.maximal;
    return found;
}

// Adds the rings as three arrays. Anisotropy is NaN where power is 0.
void add_rings(nb::dict& found, const std::vector<Ring>& rings) {
    std::vector<double> frequency, power, anisotropy;
    for (const Ring& ring : rings) {
        frequency.push_back(ring.frequency);
        power.push_back(ring.power);
        anisotropy.push_back(ring.anisotropy_db.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    found["frequency"] = array_of(std::move(frequency));
    found["power"] = array_of(std::move(power));
    found["anisotropy_db"] = array_of(std::move(anisotropy));
}

nb::dict analyze_sets(const nb::list& arrays, double width, double height, bool torus,
                      double max_frequency, std::uint32_t threads, nb::object progress) {
    std::vector<PointArray> given;
    for (const nb::handle array : arrays) given.push_back(nb::cast<PointArray>(array));
    Watch watch(std::move(progress));
    Statistics statistics;
    {
        const nb::gil_scoped_release no_gil;
        std::vector<std::vector<Point>> sets;
        for (const PointArray& array : given) sets.push_back(points_of(array));
        constexpr std::uint64_t kWhole = 1000;  // Python is given thousandths
        const auto look = [&](double share) {
            watch.look(static_cast<std::uint64_t>(share * static_cast<double>(kWhole)), kWhole);
            return true;
        };
        statistics = analyze(sets, width, height, boundary_of(torus), look, max_frequency, threads);
    }
    nb::dict found;
    add_rings(found, statistics.rings);
    found["pair_correlation"] = array_of(std::move(statistics.pair_correlation));
    found["mean_count"] = statistics.mean_count;
    found["least_distance"] = or_none(statistics.least_distance);
    found["mean_distance"] = or_none(statistics.mean_distance);
    found["relative_radius"] = or_none(statistics.relative_radius);
    found["effective_nyquist"] = or_none(statistics.effective_nyquist);
    found["oscillations"] = or_none(statistics.oscillations);
    found["psi_6"] = or_none(statistics.psi_6);
    return found;
}

}  // namespace

void add_judging(nb::module_& module) {
    nb::class_<Claim>(module, "Claim")
        .def(nb::init<>())
        .def_rw("width", &Claim::width)
        .def_rw("height", &Claim::height)
        .def_prop_rw(
            "torus", [](const Claim& claim) { return claim.boundary == Boundary::torus; },
            [](Claim& claim, bool torus) { claim.boundary = boundary_of(torus); })
        .def_rw("radius", &Claim::radius)
        .def_rw("scale", &Claim::scale)
        .def_rw("border", &Claim::border)
        .def_rw("classes", &Claim::classes)
        .def_rw("edge", &Claim::edge_tolerance)
        .def_rw("tolerance", &Claim::tolerance, nb::arg().none())
        .def_rw("distances_only", &Claim::distances_only);
    module.def("verify", verify_points, nb::arg(), nb::arg(), nb::arg().none(), nb::arg().none(),
               nb::arg(), nb::arg().none(), nb::arg().none());
    module.def("analyze", analyze_sets, nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(),
               nb::arg(), nb::arg().none());
}

}  // namespace lacuna::python
