// The functions verify and analyze.
#include <lacuna/analysis.h>
#include <lacuna/verify.h>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <algorithm>
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
#include "checks/classes.h"
#include "options.h"
#include "outlines.h"
#include "parts.h"
#include "watch.h"

namespace nb = nanobind;

namespace lacuna::python {
namespace {

// Fewer points than this are verified too fast for Ctrl-C to matter, so no thread is started.
constexpr std::size_t kFewPoints = 10000;

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

Claim asked_claim(const nb::dict& given) {
    Claim claim;
    claim.domain = domain_in(given);
    read_classes(given, claim.classes);
    read_places(given, claim.places);
    read(given, "radius", claim.radius);
    read(given, "scale", claim.scale);
    read(given, "tolerance", claim.tolerance);
    read(given, "distances_only", claim.distances_only);
    claim.distances_only |= !has_open_class(claim.classes);
    return claim;
}

// The attributes of a Verdict, None where nothing is known.
nb::dict verdict_of(const Proof& proof, const Claim& claim) {
    nb::dict found;
    const bool in_place = !proof.outside && !proof.moved && !proof.miscounted && !proof.forbidden;
    const bool gaps_known = in_place && !claim.distances_only;
    const auto known = [](bool is_known, auto value) {
        return is_known ? nb::cast(value) : nb::object(nb::none());
    };
    found["holds"] = in_place && proof.kept && (claim.distances_only || proof.covered);
    found["maximal"] = proof.maximal;
    found["kept"] = known(in_place, proof.kept);
    found["covered"] = known(gaps_known, proof.covered);
    found["outside"] = or_none(proof.outside);
    found["moved"] = or_none(proof.moved);
    found["miscounted"] = nb::none();
    if (proof.miscounted) found["miscounted"] = claim.classes.names[*proof.miscounted];
    found["forbidden"] = or_none(proof.forbidden);
    found["forbidden_by"] = known(proof.forbidden.has_value(), name_of(proof.forbidden_by));
    // Neighbours count, too.
    const bool has_pair = in_place && std::isfinite(proof.least_distance);
    found["closest_pair"] = known(has_pair, std::pair(proof.first, proof.second));
    found["least_distance"] =
        has_pair ? proof.least_distance : std::numeric_limits<double>::infinity();
    found["least_limit"] = known(has_pair, proof.least_limit);
    const bool has_gap = gaps_known && std::isfinite(proof.largest_gap_distance);
    found["largest_gap"] = known(has_gap, std::pair(proof.largest_gap.x, proof.largest_gap.y));
    found["largest_gap_distance"] = known(has_gap, proof.largest_gap_distance);
    found["largest_gap_limit"] = known(has_gap, proof.largest_gap_limit);
    found["largest_gap_class"] = nb::none();
    if (has_gap && !claim.classes.names.empty())
        found["largest_gap_class"] = claim.classes.names[proof.largest_gap_class];
    found["tolerance"] = proof.tolerance;
    found["radius"] = claim.radius;
    found["scale"] = nb::none();
    if (claim.field != nullptr) {
        found["scale"] = claim.scale;
        const auto& importance = claim.field->importance;
        found["radius"] =
            claim.scale / std::sqrt(*std::max_element(importance.begin(), importance.end()));
    }
    return found;
}

nb::dict verify_points(const PointArray& array, const nb::dict& given, const Field* field,
                       const nb::list& places, const std::optional<PointArray>& keep,
                       const std::optional<ClassArray>& keep_classes,
                       const std::optional<ClassArray>& class_of) {
    const Outlines outlines(places);
    Claim claim = asked_claim(given);
    std::vector<Point> kept;
    std::vector<std::uint8_t> of_points, of_kept;
    const auto work = [&](const std::atomic<bool>& stop) {
        if (keep) kept = points_of(*keep);
        if (class_of) of_points = classes_of(*class_of);
        if (keep_classes) of_kept = classes_of(*keep_classes);
        claim.field = field;
        claim.places.outlines = outlines.copy();
        claim.keep = kept;
        claim.keep_classes = of_kept;
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
    return verdict_of(proof, claim);
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

// The attributes of an Analysis.
nb::dict analyze_sets(const nb::list& arrays, const nb::dict& given_options, nb::object progress) {
    const Domain domain = domain_in(given_options);
    double max_frequency = 2;
    std::uint32_t threads = 0;
    read(given_options, "max_frequency", max_frequency);
    read(given_options, "threads", threads);
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
        statistics = analyze(sets, domain, look, max_frequency, threads);
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
    module.def("verify", verify_points, nb::arg(), nb::arg(), nb::arg().none(), nb::arg(),
               nb::arg().none(), nb::arg().none(), nb::arg().none());
    module.def("analyze", analyze_sets, nb::arg(), nb::arg(), nb::arg().none());
}

}  // namespace lacuna::python
