// Requests, fields, and the functions that make points: sample, sample_many, relax and order.
#include <lacuna/lacuna.h>
#include <lacuna/many.h>
#include <lacuna/order.h>
#include <lacuna/pictures.h>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "parts.h"
#include "recipes/make.h"
#include "recipes/settle.h"
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

}  // namespace

nb::dict dict_of(Result result) {
    nb::dict made;
    made["points"] = array_of(std::move(result.points));
    made["class_of"] =
        result.classes.empty() ? nb::object(nb::none()) : array_of(std::move(result.classes));
    made["radius"] = result.radius;
    made["scale"] = result.scale;
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
    return made;
}

nb::dict dict_of(Relaxed relaxed) {
    nb::dict made;
    made["points"] = array_of(std::move(relaxed.points));
    made["lattice"] = nb::make_tuple(relaxed.lattice_columns, relaxed.lattice_rows);
    made["evenness"] = nb::none();
    if (relaxed.evenness)
        made["evenness"] = nb::make_tuple(relaxed.evenness->before, relaxed.evenness->after,
                                          relaxed.evenness->after_voronoi);
    made["backend"] = relaxed.backend;
    made["device"] = relaxed.device;
    return made;
}

namespace {

// Samples, and moves the points if that is asked for.
nb::dict sample_points(const Request& wanted, const Field* field, const Mask* mask,
                       const std::optional<PointArray>& keep,
                       const std::optional<ClassArray>& keep_classes, const recipes::Moves& moves,
                       nb::object progress) {
    Request request = wanted;
    request.field = field;
    request.mask = mask;
    Watch watch(std::move(progress));
    recipes::Made set;
    std::vector<Ellipse> ellipses;
    {
        const nb::gil_scoped_release no_gil;
        const std::vector<Point> kept = keep ? points_of(*keep) : std::vector<Point>{};
        request.keep = kept;
        const std::vector<std::uint8_t> of_kept =
            keep_classes ? classes_of(*keep_classes) : std::vector<std::uint8_t>{};
        request.keep_classes = of_kept;
        set = recipes::make(request, moves, watch);
        if (field != nullptr && !field->stretches.empty())
            ellipses = ellipses_of(set.result.points, *field, set.result.scale, request.width,
                                   request.height);
    }
    nb::dict made = dict_of(std::move(set.result));
    made["ellipses"] = ellipses.empty() ? nb::object(nb::none()) : array_of(std::move(ellipses));
    made["relaxed"] = nb::none();
    if (set.relaxed) made["relaxed"] = dict_of(std::move(*set.relaxed));
    made["seconds"] = watch.seconds();
    return made;
}

// Returns a dict for each seed.
nb::list sample_many_points(const Request& request, const std::vector<std::uint64_t>& seeds,
                            nb::object progress) {
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
    for (Result& result : results) all.append(dict_of(std::move(result)));
    return all;
}

nb::dict relax_points(const PointArray& array, const Field* field, const RelaxOptions& options,
                      nb::object progress) {
    Watch watch(std::move(progress));
    Relaxed relaxed;
    {
        const nb::gil_scoped_release no_gil;
        relaxed = relax(points_of(array), field, options, watch);
    }
    nb::dict made = dict_of(std::move(relaxed));
    made["seconds"] = watch.seconds();
    return made;
}

// The indices of the points in a progressive order.
nb::object order_points(const PointArray& array, const Field* field, double width, double height,
                        bool torus, std::uint64_t seed) {
    const std::vector<Point> points = points_of(array);
    std::vector<std::uint32_t> order;
    {
        const Unlocked unlocked;
        order = progressive_order(points, field,
                                  {width, height, torus ? Boundary::torus : Boundary::box, seed});
    }
    return array_of(std::move(order));
}

// Decides the mode and the metric of a request. Returns how often the points are relaxed.
std::uint32_t settle(Request& request, const std::optional<std::string>& mode,
                     const std::optional<std::string>& metric, std::optional<std::uint32_t> relax,
                     std::uint32_t gaussian, bool has_ellipses) {
    recipes::Given given{.has_ellipses = has_ellipses, .relax = relax, .gaussian = gaussian};
    if (mode) given.mode = named<Mode>(*mode, "mode");
    if (metric) given.metric = named<Metric>(*metric, "metric");
    recipes::settle(given, request);
    return recipes::relax_of(given);
}

// Adds the attributes for the domain, the backend, the device and threads.
template <typename Options>
nb::class_<Options>& add_common(nb::class_<Options>& type) {
    return type.def(nb::init<>())
        .def_rw("width", &Options::width)
        .def_rw("height", &Options::height)
        .def_prop_rw(
            "torus", [](const Options& options) { return options.boundary == Boundary::torus; },
            [](Options& options, bool torus) {
                options.boundary = torus ? Boundary::torus : Boundary::box;
            })
        .def_rw("backend", &Options::backend)
        .def_rw("device", &Options::device)
        .def_rw("threads", &Options::threads);
}

void add_classes(nb::module_& module) {
    nb::class_<Classes>(module, "Classes")
        .def(nb::init<>())
        .def_rw("names", &Classes::names)
        .def_rw("distances", &Classes::distances)
        .def_rw("weights", &Classes::weights);
    module.def("distances_by_sum",
               [](const std::vector<double>& radii) { return distances_by_sum(radii); });
    module.def("distances_by_union",
               [](const std::vector<double>& radii) { return distances_by_union(radii); });
}

void add_request(nb::module_& module) {
    nb::class_<Request> request(module, "Request");
    add_common(request)
        .def_rw("radius", &Request::radius, nb::arg().none())
        .def_rw("count", &Request::count, nb::arg().none())
        .def_rw("scale", &Request::scale, nb::arg().none())
        .def_rw("border", &Request::border)
        .def_rw("classes", &Request::classes)
        .def_rw("lines_per_radius", &Request::lines_per_radius, nb::arg().none())
        .def_rw("progressive", &Request::progressive)
        .def_rw("limit", &Request::limit, nb::arg().none())
        .def_rw("snap", &Request::snap)
        .def_rw("uniform_x", &Request::uniform_x)
        .def_rw("round_size", &Request::round_size)
        .def_rw("seed", &Request::seed)
        .def_rw("memory_limit", &Request::memory_limit_bytes)
        .def_prop_rw(
            "mode", [](const Request& r) { return std::string(name_of(r.mode)); },
            [](Request& r, const std::string& name) { r.mode = named<Mode>(name, "mode"); })
        .def_prop_rw(
            "metric", [](const Request& r) { return std::string(name_of(r.metric)); },
            [](Request& r, const std::string& name) { r.metric = named<Metric>(name, "metric"); });
}

}  // namespace

void add_sampling(nb::module_& module) {
    nb::class_<Field>(module, "Field")
        .def_ro("rows", &Field::rows)
        .def_ro("columns", &Field::columns)
        .def_prop_ro("has_ellipses", [](const Field& field) { return !field.stretches.empty(); })
        .def_prop_ro("values", values_of);
    nb::class_<Tone>(module, "Tone")
        .def(nb::init<>())
        .def_rw("black", &Tone::black)
        .def_rw("white", &Tone::white)
        .def_rw("auto_levels", &Tone::auto_levels)
        .def_rw("invert", &Tone::invert)
        .def_rw("gamma", &Tone::gamma)
        .def_rw("min_importance", &Tone::min_importance)
        .def_rw("along", &Tone::along)
        .def_rw("sharpen", &Tone::sharpen)
        .def_rw("sharpen_amount", &Tone::sharpen_amount);
    add_classes(module);
    add_request(module);
    nb::class_<RelaxOptions> options(module, "RelaxOptions");
    add_common(options)
        .def_rw("iterations", &RelaxOptions::iterations)
        .def_rw("gaussian", &RelaxOptions::gaussian)
        .def_rw("gaussian_distance", &RelaxOptions::gaussian_distance)
        .def_rw("measure", &RelaxOptions::measure);
    module.def("make_field", make_field);
    module.def("ellipse_field", field_of_ellipses);
    nb::class_<recipes::Moves>(module, "Moves")
        .def(nb::init<>())
        .def_rw("iterations", &recipes::Moves::iterations)
        .def_rw("gaussian", &recipes::Moves::gaussian)
        .def_prop_rw(
            "gaussian_distance",
            [](const recipes::Moves& moves) {
                return relax_options_of({}, moves).gaussian_distance;
            },
            [](recipes::Moves& moves, double distance) { moves.gaussian_distance = distance; });
    module.def("sample", sample_points, nb::arg(), nb::arg().none(), nb::arg().none(),
               nb::arg().none(), nb::arg().none(), nb::arg(), nb::arg().none());
    module.def("sample_many", sample_many_points, nb::arg(), nb::arg(), nb::arg().none());
    module.def("relax", relax_points, nb::arg(), nb::arg().none(), nb::arg(), nb::arg().none());
    module.def("progressive_order", order_points, nb::arg(), nb::arg().none(), nb::arg(), nb::arg(),
               nb::arg(), nb::arg());
    module.def("settle", settle, nb::arg(), nb::arg().none(), nb::arg().none(), nb::arg().none(),
               nb::arg(), nb::arg());
}

}  // namespace lacuna::python
