// Point files and pictures, as the command writes them.
#include "files/point_files.h"

#include <lacuna/lacuna.h>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/vector.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "drawing/picture.h"
#include "files/formats.h"
#include "parts.h"

namespace nb = nanobind;

namespace lacuna::python {
namespace {

// Writes points in the format of the path's extension. `radius` is as in files::PointSet. Pictures
// have dots of the given radii; without them all dots are equal. `layers` are inks, each with its
// number of dots; without them the dots are black. With `classes`, class_of has each point's.
void write_set(const nb::bytes& path_bytes, const PointArray& array, double width, double height,
               double radius, const std::optional<RadiusArray>& radii,
               const std::vector<std::pair<Ink, std::size_t>>& layers,
               const std::vector<std::string>& classes, const std::optional<ClassArray>& class_of) {
    const std::string path(path_bytes.c_str(), path_bytes.size());
    const nb::gil_scoped_release no_gil;
    const files::Format& format = files::format_of(path);
    const std::vector<Point> points = points_of(array);
    std::vector<files::Layer> its_layers;
    for (const auto& [ink, dots] : layers) its_layers.push_back({ink, dots});
    files::PointSet set{points, width, height, radius};
    const std::vector<std::uint8_t> of_points =
        class_of ? classes_of(*class_of) : std::vector<std::uint8_t>{};
    if (class_of) {
        its_layers = files::layers_of_classes(classes, of_points);
        set.layer_of_point = of_points;
        set.layers_are = files::LayersAre::classes;
    }
    set.layers = its_layers;
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
    module.def("write_points", write_set, nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(),
               nb::arg().none(), nb::arg(), nb::arg(), nb::arg().none());
}

}  // namespace lacuna::python
