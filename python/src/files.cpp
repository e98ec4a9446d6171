// Point files and pictures, as the command writes them.
#include "files/point_files.h"

#include <lacuna/lacuna.h>
#include <lacuna/version.h>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "drawing/picture.h"
#include "files/formats.h"
#include "parts.h"
#include "watch.h"

namespace nb = nanobind;

namespace lacuna::python {
namespace {

// What a file says of a set besides its points. Layers are inks, each with its number of dots;
// without them the dots are black.
struct Saved {
    double width = 1;
    double height = 1;
    bool torus = false;
    bool is_relaxed = false;
    double radius = 0;        // of which a dot has a third; 0: not known
    double least_radius = 0;  // that .json holds
    std::vector<std::pair<Ink, std::size_t>> layers;
    std::vector<std::string> classes;
    // How it was made: for .json. No mode: not known.
    std::string mode;
    std::uint64_t seed = 0;
    bool maximal = false;
    double scale = 0;
    std::string options;  // as JSON
    std::vector<std::pair<double, std::uint64_t>> levels;
};

files::Origin origin_of(const Saved& saved) {
    files::Origin origin;
    origin.version = LACUNA_VERSION;
    origin.boundary = saved.torus ? Boundary::torus : Boundary::box;
    for (const Mode mode : {Mode::exact, Mode::lines, Mode::cells, Mode::stratified})
        if (name_of(mode) == saved.mode) origin.mode = mode;
    origin.seed = saved.seed;
    origin.maximal = saved.maximal;
    origin.options = saved.options;
    for (const auto& [size, points] : saved.levels) origin.levels.push_back({size, points});
    origin.scale = saved.scale;
    return origin;
}

std::vector<Ellipse> ellipses_in(const std::optional<EllipseArray>& array) {
    std::vector<Ellipse> ellipses;
    for (std::size_t i = 0; array && i < array->shape(0); ++i) {
        const double* const at = array->data() + 3 * i;
        ellipses.push_back({at[0], at[1], at[2]});
    }
    return ellipses;
}

// Writes points in the format of the path's extension. Pictures have dots of the given radii;
// without them all dots are equal. With classes, class_of has each point's.
void write_set(const nb::bytes& path_bytes, const PointArray& array, const Saved& saved,
               const std::optional<RadiusArray>& radii, const std::optional<ClassArray>& class_of,
               const std::optional<EllipseArray>& ellipse_array) {
    const std::string path(path_bytes.c_str(), path_bytes.size());
    const Unlocked unlocked;
    const files::Format& format = files::format_of(path);
    const std::vector<Point> points = points_of(array);
    std::vector<files::Layer> its_layers;
    for (const auto& [ink, dots] : saved.layers) its_layers.push_back({ink, dots});
    files::PointSet set{points, saved.width, saved.height, saved.radius};
    set.boundary = saved.torus ? Boundary::torus : Boundary::box;
    set.is_relaxed = saved.is_relaxed;
    const files::Origin origin = origin_of(saved);
    if (format.name() == "json") {
        set.radius = saved.least_radius;
        if (!saved.mode.empty()) set.origin = &origin;
    }
    const std::vector<std::uint8_t> of_points =
        class_of ? classes_of(*class_of) : std::vector<std::uint8_t>{};
    if (class_of) {
        its_layers = files::layers_of_classes(saved.classes, of_points);
        set.layer_of_point = of_points;
        set.layers_are = files::LayersAre::classes;
    }
    set.layers = its_layers;
    const std::vector<Ellipse> ellipses = ellipses_in(ellipse_array);
    set.ellipses = ellipses;
    set.writes_ellipses = !ellipses.empty();
    std::string content;
    if (format.medium && radii) {
        std::vector<double> diameters(radii->shape(0));
        for (std::size_t i = 0; i < diameters.size(); ++i) diameters[i] = 2 * radii->data()[i];
        drawing::Style style;
        style.diameters = diameters;
        content = drawing::draw(set, *format.medium, style);
    } else {
        content = files::encode(set, format);
    }
    files::write_whole(path, content);
}

}  // namespace

void add_files(nb::module_& module) {
    nb::class_<Saved>(module, "Saved")
        .def(nb::init<>())
        .def_rw("width", &Saved::width)
        .def_rw("height", &Saved::height)
        .def_rw("torus", &Saved::torus)
        .def_rw("is_relaxed", &Saved::is_relaxed)
        .def_rw("radius", &Saved::radius)
        .def_rw("least_radius", &Saved::least_radius)
        .def_rw("layers", &Saved::layers)
        .def_rw("classes", &Saved::classes)
        .def_rw("mode", &Saved::mode)
        .def_rw("seed", &Saved::seed)
        .def_rw("maximal", &Saved::maximal)
        .def_rw("scale", &Saved::scale)
        .def_rw("options", &Saved::options)
        .def_rw("levels", &Saved::levels);
    module.def("write_points", write_set, nb::arg(), nb::arg(), nb::arg(), nb::arg().none(),
               nb::arg().none(), nb::arg().none());
}

}  // namespace lacuna::python
