// Point files and pictures, as the command writes them.
#include "files/point_files.h"

#include <lacuna/lacuna.h>
#include <lacuna/version.h>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <nanobind/stl/array.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "checks/classes.h"
#include "drawing/picture.h"
#include "files/formats.h"
#include "options.h"
#include "options/read.h"
#include "options/words.h"
#include "parts.h"
#include "watch.h"

namespace nb = nanobind;

namespace lacuna::python {
namespace {

// How a set was made, for .json; without a mode it is not known.
files::Origin origin_in(const nb::dict& saved) {
    files::Origin origin{.version = LACUNA_VERSION};
    std::string mode;
    read(saved, "mode", mode);
    if (!mode.empty()) origin.mode = options::named<Mode>(mode).value();
    read(saved, "seed", origin.seed);
    origin.maximal.emplace(false);
    read(saved, "maximal", *origin.maximal);
    read(saved, "scale", origin.scale);
    read(saved, "options", origin.options);
    std::vector<std::pair<double, std::uint64_t>> levels;
    read(saved, "levels", levels);
    for (const auto& [size, points] : levels) origin.levels.push_back({size, points});
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
// without them all dots are equal. With classes, class_of has each point's. `saved` has what a file
// says besides: layers are inks, each with its number of dots, without which the dots are black; a
// dot has a third of the radius; .json has the least radius.
void write_set(const nb::bytes& path_bytes, const PointArray& array, const nb::dict& saved,
               const std::optional<RadiusArray>& radii, const std::optional<ClassArray>& class_of,
               const std::optional<EllipseArray>& ellipse_array) {
    const std::string path(path_bytes.c_str(), path_bytes.size());
    const Domain domain = domain_in(saved);
    double radius = 0;
    double least_radius = 0;
    bool is_relaxed = false;
    std::vector<std::pair<Ink, std::size_t>> layers;
    std::vector<std::string> classes;
    read(saved, "radius", radius);
    read(saved, "least_radius", least_radius);
    read(saved, "is_relaxed", is_relaxed);
    read(saved, "layers", layers);
    read(saved, "classes", classes);
    std::vector<double> radii_of_classes;
    read(saved, "radii_of_classes", radii_of_classes);
    std::string on_pixels, paper_colour = "white";
    read(saved, "on_pixels", on_pixels);
    read(saved, "paper_colour", paper_colour);
    drawing::Style style;
    std::array<double, 3> paper{};
    read(saved, "paper", paper);
    if (paper[0] > 0) style.sheet = Paper{paper[0], paper[1], paper[2]};
    read(saved, "are_strokes", style.are_strokes);
    read(saved, "pen_mm", style.pen_mm);
    read(saved, "circles", style.circles);
    read(saved, "line_width", style.line_width);
    std::vector<std::pair<double, double>> plots;
    read(saved, "layer_plots", plots);
    for (const auto& [length, seconds] : plots) style.layer_plots.push_back({length, seconds});
    read(saved, "for_a_pen", style.for_a_pen);
    const files::Origin origin = origin_in(saved);
    const Unlocked unlocked;
    const files::Format& format = files::format_of(path);
    const std::vector<Point> points = points_of(array);
    std::vector<files::Layer> its_layers;
    for (const auto& [ink, dots] : layers) its_layers.push_back({ink, dots});
    files::PointSet set{points, domain, radius};
    set.is_relaxed = is_relaxed;
    if (!on_pixels.empty()) options::read_raster("on_pixels", on_pixels, set.on_pixels.emplace());
    if (format.name() == "json") {
        set.radius = least_radius;
        if (origin.mode) set.origin = &origin;
    }
    const std::vector<std::uint8_t> of_points =
        class_of ? classes_of(*class_of) : std::vector<std::uint8_t>{};
    if (class_of) {
        its_layers = files::layers_of_classes(classes, of_points);
        set.layer_of_point = of_points;
        set.layers_are = files::LayersAre::classes;
    }
    std::vector<files::Column> columns;
    if (has_sizes({.names = classes}))
        columns.push_back(files::radius_of_each(of_points, radii_of_classes));
    set.more = columns;
    set.layers = its_layers;
    const std::vector<Ellipse> ellipses = ellipses_in(ellipse_array);
    set.ellipses = ellipses;
    set.writes_ellipses = !ellipses.empty();
    std::vector<double> diameters(radii ? radii->shape(0) : 0);
    for (std::size_t i = 0; i < diameters.size(); ++i) diameters[i] = 2 * radii->data()[i];
    style.diameters = diameters;
    style.paper_colour = paper_of(paper_colour);
    files::write_whole(path, drawing::encode(set, format, style));
}

}  // namespace

void add_files(nb::module_& module) {
    module.def("write_points", write_set, nb::arg(), nb::arg(), nb::arg(), nb::arg().none(),
               nb::arg().none(), nb::arg().none());
}

}  // namespace lacuna::python
