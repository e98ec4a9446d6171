// Fields, and the functions that make points: sample, sample_many, relax and order.
#include <lacuna/domains.h>
#include <lacuna/lacuna.h>
#include <lacuna/many.h>
#include <lacuna/order.h>
#include <lacuna/pictures.h>
#include <lacuna/threshold_mask.h>
#include <lacuna/verify.h>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "arrays.h"
#include "checks/classes.h"
#include "options.h"
#include "options/chunk.h"
#include "options/classes.h"
#include "options/settle.h"
#include "outlines.h"
#include "parts.h"
#include "plan/kept.h"
#include "watch.h"

namespace nb = nanobind;

namespace lacuna::python {
namespace {

using Values = nb::ndarray<double, nb::numpy, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

Field make_field(std::uint32_t rows, std::uint32_t columns) {
    return {columns, rows, std::vector<double>(std::size_t{columns} * rows)};
}

// The numbers of a field as an array for numpy to fill. No other thread changes them.
Values values_of(Field& field) {
    return Values(field.importance.data(), {field.rows, field.columns}, nb::find(field));
}

static_assert(sizeof(Ellipse) == 3 * sizeof(double), "ellipses are rows of three numbers");
using EllipseArray =
    nb::ndarray<const double, nb::numpy, nb::shape<-1, -1, 3>, nb::c_contig, nb::device::cpu>;

Field field_of_ellipses(const EllipseArray& array) {
    const Unlocked unlocked;
    std::vector<Ellipse> ellipses(array.shape(0) * array.shape(1));
    const double* from = array.data();
    for (Ellipse& ellipse : ellipses) {
        ellipse = {from[0], from[1], from[2]};
        from += 3;
    }
    return ellipse_field(static_cast<std::uint32_t>(array.shape(1)),
                         static_cast<std::uint32_t>(array.shape(0)), ellipses);
}

// What verify proves of a set unless it is told otherwise.
nb::dict promises_of(const Claim& claim) {
    nb::dict promised;
    promised["radius"] = claim.radius;
    promised["scale"] = claim.scale;
    promised["border"] = claim.places.border;
    promised["borders"] = claim.places.borders;
    promised["distances_only"] = claim.distances_only;
    promised["weights"] = claim.classes.weights;
    promised["counts"] = claim.classes.counts;
    promised["priority"] = claim.classes.by_priority;
    const SortedKept kept = sorted_kept({.domain = claim.domain,
                                         .radius = claim.radius,
                                         .classes = claim.classes,
                                         .keep = claim.keep,
                                         .keep_classes = claim.keep_classes});
    const auto members = static_cast<std::ptrdiff_t>(kept.members);
    promised["kept"] = kept.members;
    promised["neighbours"] =
        array_of(std::vector<Point>(kept.points.begin() + members, kept.points.end()));
    std::vector<std::uint8_t> of_neighbours;
    if (!kept.classes.empty())
        of_neighbours.assign(kept.classes.begin() + members, kept.classes.end());
    promised["of_neighbours"] = array_of(std::move(of_neighbours));
    promised["inside_by_radius"] = claim.places.border_by_radius;
    promised["edge"] = claim.places.edge.value_or(0);
    promised["has_mask"] = claim.places.mask != nullptr || !claim.places.masks.empty() ||
                           !claim.places.outlines.empty();
    promised["has_field"] = claim.field != nullptr;
    promised["has_ellipses"] = claim.field != nullptr && !claim.field->stretches.empty();
    return promised;
}

// The distances that classes keep in a set, row by row.
std::vector<double> kept_distances(const Request& request, const Result& result) {
    std::vector<double> distances = request.classes.distances;
    const double factor = distance_factor(request, result);
    for (double& distance : distances) distance *= factor;
    return distances;
}

}  // namespace

nb::dict dict_of(Result result, const Request& request, const std::optional<Relaxed>& moved) {
    nb::dict made;
    Request promise = request;
    if (moved) promise.mode = Mode::stratified;  // moved points keep their least distance alone
    made["_promised"] = promises_of(claim_of(promise, result));
    made["_request"] = described(request, result);
    made["classes"] = nb::tuple(nb::cast(request.classes.names));
    made["class_of"] = made["distances"] = nb::none();
    if (!request.classes.names.empty()) {
        made["distances"] = array_of(kept_distances(request, result));
        made["class_of"] = array_of(std::move(result.classes));
    }
    made["relaxed"] = moved ? nb::object(dict_of(*moved)) : nb::none();
    made["points"] = array_of(std::move(result.points));
    made["domain"] = nb::make_tuple(request.domain.width, request.domain.height);
    made["torus"] = request.domain.wraps();
    made["mode"] = name_of(request.mode);
    made["metric"] = name_of(request.metric);
    made["seed"] = request.seed;
    made["radius"] = result.radius;
    const bool has_scale = request.field != nullptr && result.scale > 0;
    made["scale"] = has_scale ? nb::cast(result.scale) : nb::none();
    made["lines_per_radius"] = result.lines_per_radius;
    made["maximal"] = result.maximal;
    nb::list levels;
    for (const Level& level : result.levels)
        levels.append(nb::make_tuple(level.size, level.points));
    made["levels"] = nb::tuple(levels);
    made["rounds"] = result.rounds;
    made["draws"] = result.draws;
    made["backend"] = result.backend;
    made["device"] = result.device;
    made["ellipses"] = nb::none();
    return made;
}

nb::dict dict_of(const Relaxed& relaxed) {
    nb::dict made;
    made["lattice"] = nb::make_tuple(relaxed.lattice_columns, relaxed.lattice_rows);
    made["evenness"] = nb::none();
    if (const auto& evenness = relaxed.evenness)
        made["evenness"] =
            nb::make_tuple(evenness->before, evenness->after, evenness->after_voronoi);
    made["backend"] = relaxed.backend;
    made["device"] = relaxed.device;
    return made;
}

void read_classes(const nb::dict& given, Classes& classes) {
    read(given, "class_names", classes.names);
    read(given, "distances", classes.distances);
    read(given, "weights", classes.weights);
    read(given, "counts", classes.counts);
    read(given, "priority", classes.by_priority);
}

void read_places(const nb::dict& given, Places& places) {
    read(given, "mask", places.mask);
    read(given, "masks", places.masks);
    read(given, "border", places.border);
    read(given, "borders", places.borders);
    read(given, "edge", places.edge);
    read(given, "inside_by_radius", places.border_by_radius);
}

namespace {

// The domain as it was given: corner and sides are no exact sums.
void keep_domain(const nb::dict& given, nb::dict& made) {
    if (given.contains("domain")) made["domain"] = given["domain"];
}

// Decides the mode and the metric of a request that has its field.
void settle(const nb::dict& given, const options::Moves& moves, Request& request) {
    const bool has_ellipses = request.field != nullptr && !request.field->stretches.empty();
    options::Choices asked{.has_ellipses = has_ellipses,
                           .has_domain = true,
                           .relax = moves.iterations,
                           .gaussian = moves.gaussian};
    read(given, options::Targets{{"mode", &asked.mode}, {"metric", &asked.metric}});
    options::settle(asked, request);
}

// Samples, and moves the points if that is asked for. Returns the attributes of a PointSet.
nb::dict sample_points(const nb::dict& given, const Field* field, const nb::list& places,
                       const std::optional<PointArray>& keep,
                       const std::optional<ClassArray>& keep_classes, nb::object progress) {
    refuse_pairs(given);
    Request request = request_of(given);
    request.field = field;
    const options::Moves moves = moves_of(given);
    settle(given, moves, request);
    const Outlines outlines(places);
    options::ChunkOptions chunk_options;
    read(given, options::targets_of(chunk_options));
    std::optional<Chunk> chunk;
    Watch watch(std::move(progress));
    options::Made set;
    std::vector<Ellipse> ellipses;
    std::vector<Point> kept;
    std::vector<std::uint8_t> of_kept;
    {
        const nb::gil_scoped_release no_gil;
        if (keep) kept = points_of(*keep);
        if (keep_classes) of_kept = classes_of(*keep_classes);
        request.keep = kept;
        request.keep_classes = of_kept;
        request.places.outlines = outlines.copy();
        chunk = options::chunk_of(chunk_options, request);
        if (chunk) request = chunk->request;
        set = options::make(request, moves, watch);
        if (field != nullptr && !field->stretches.empty())
            ellipses = ellipses_of(set.result.points, *field, set.result.scale, request.domain);
    }
    nb::dict made = dict_of(std::move(set.result), request, set.relaxed);
    keep_domain(given, made);
    if (!ellipses.empty()) made["ellipses"] = array_of(std::move(ellipses));
    made["seconds"] = watch.seconds();
    return made;
}

// The points that all tiles share.
TileRing tile_ring(const nb::dict& given, std::uint64_t seed, double width) {
    Request request = request_of(given);
    settle(given, {}, request);
    request.seed = seed;
    Watch watch{nb::none()};
    const nb::gil_scoped_release no_gil;
    return tile_ring(request, width, watch);
}

// Returns the attributes of a PointSet for each seed.
nb::list sample_many_points(const nb::dict& given, const std::vector<std::uint64_t>& seeds,
                            const std::optional<TileRing>& frame, nb::object progress) {
    refuse_pairs(given);
    Request request = request_of(given);
    settle(given, {}, request);
    if (frame) {
        request.keep = frame->points;
        request.keep_classes = frame->classes;
    }
    Watch watch(std::move(progress));
    std::vector<Result> results;
    {
        const nb::gil_scoped_release no_gil;
        results.reserve(seeds.size());
        sample_many(
            request, seeds, [&](std::uint64_t, Result set) { results.push_back(std::move(set)); },
            watch);
    }
    nb::list all;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        request.seed = seeds[i];
        nb::dict made = dict_of(std::move(results[i]), request, std::nullopt);
        keep_domain(given, made);
        all.append(made);
    }
    return all;
}

// Returns the attributes of a Relaxed.
nb::dict relax_points(const PointArray& array, const Field* field, const nb::dict& given,
                      nb::object progress) {
    RelaxOptions options;
    options.domain = domain_in(given);
    options.run_on = run_on_in(given);
    read(given, "iterations", options.iterations);
    read(given, "gaussian", options.gaussian);
    read(given, "gaussian_distance", options.gaussian_distance);
    read(given, "measure", options.measure);
    options::check_moves({}, moves_of(given));  // a distance of steps without steps
    Watch watch(std::move(progress));
    Relaxed relaxed;
    {
        const nb::gil_scoped_release no_gil;
        relaxed = relax(points_of(array), field, options, watch);
    }
    nb::dict made = dict_of(relaxed);
    made["points"] = array_of(std::move(relaxed.points));
    made["seconds"] = watch.seconds();
    return made;
}

// The indices of the points in a progressive order.
nb::object order_points(const PointArray& array, const Field* field, const nb::dict& given) {
    OrderOptions options;
    options.domain = domain_in(given);
    read(given, "seed", options.seed);
    const std::vector<Point> points = points_of(array);
    std::vector<std::uint32_t> order;
    {
        const Unlocked unlocked;
        order = progressive_order(points, field, options);
    }
    return array_of(std::move(order));
}

nb::object ranks_of_mask(std::uint32_t columns, std::uint32_t rows, std::uint64_t seed,
                         std::uint32_t frames) {
    ThresholdMask mask;
    {
        const Unlocked unlocked;
        mask = threshold_mask(columns, rows, seed, frames);
    }
    return array_of(std::move(mask.ranks));
}

// The name, radius, weight and number of points of each size of a class, as --class reads them.
auto sizes_of_class(const std::string& text, const std::string& between, bool by_priority) {
    const Classes classes = options::read_classes({{text}, between, by_priority}, nullptr);
    std::vector<std::tuple<std::string, double, double, std::optional<std::uint64_t>>> all;
    for (std::size_t i = 0; i < classes.names.size(); ++i)
        all.emplace_back(classes.names[i], own_distance_of(classes, i) / 2, classes.weights[i],
                         classes.counts[i]);
    return all;
}

}  // namespace

void add_sampling(nb::module_& module) {
    nb::class_<Field>(module, "Field")
        .def_ro("rows", &Field::rows)
        .def_ro("columns", &Field::columns)
        .def_prop_ro("has_ellipses", [](const Field& field) { return !field.stretches.empty(); })
        .def_prop_ro("values", values_of);
    module.def("distances_by_sum",
               [](const std::vector<double>& radii) { return distances_by_sum(radii); });
    module.def("distances_by_union",
               [](const std::vector<double>& radii) { return distances_by_union(radii); });
    module.def("sizes_of_class", sizes_of_class);
    module.def("make_field", make_field);
    module.def("ellipse_field", field_of_ellipses);
    module.def("sample", sample_points, nb::arg(), nb::arg().none(), nb::arg(), nb::arg().none(),
               nb::arg().none(), nb::arg().none());
    nb::class_<TileRing>(module, "TileRing");
    module.def("tile_ring", tile_ring);
    module.def("sample_many", sample_many_points, nb::arg(), nb::arg(), nb::arg().none(),
               nb::arg().none());
    module.def("relax", relax_points, nb::arg(), nb::arg().none(), nb::arg(), nb::arg().none());
    module.def("threshold_mask", ranks_of_mask);
    module.def("progressive_order", order_points, nb::arg(), nb::arg().none(), nb::arg());
}

}  // namespace lacuna::python
