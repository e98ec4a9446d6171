// Stippled pictures.
#include <lacuna/stipple.h>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "files/point_files.h"
#include "parts.h"
#include "watch.h"

namespace nb = nanobind;

namespace lacuna::python {
namespace {

std::string bytes_of(const nb::bytes& bytes) {
    return {static_cast<const char*>(bytes.data()), bytes.size()};
}

Picture read_file(const nb::bytes& path) {
    const std::string name = bytes_of(path);
    const Unlocked unlocked;
    return read_picture(name);
}

// The dots of a picture as attributes of a Stippling.
nb::dict stipple_picture(const Picture& picture, const StippleOptions& options,
                         nb::object progress) {
    Watch watch(std::move(progress));
    Stippling dots;
    {
        const nb::gil_scoped_release no_gil;
        dots = stipple(picture, options, watch);
    }
    std::vector<std::uint8_t> ink;
    for (std::size_t k = 0; k < dots.layers.size(); ++k)
        ink.insert(ink.end(), dots.layers[k].dots, static_cast<std::uint8_t>(k));
    for (double& diameter : dots.diameters) diameter /= 2;
    nb::dict made = dict_of(std::move(dots.result));
    made["radii"] = array_of(std::move(dots.diameters));
    made["ellipses"] =
        dots.ellipses.empty() ? nb::object(nb::none()) : array_of(std::move(dots.ellipses));
    made["ink"] = dots.layers.empty() ? nb::object(nb::none()) : array_of(std::move(ink));
    made["request"] = std::move(dots.request);
    made["iterations"] = dots.iterations;
    made["relaxed"] = nb::none();
    if (dots.relaxed) made["relaxed"] = dict_of(std::move(*dots.relaxed));
    made["seconds"] = watch.seconds();
    return made;
}

void add_options(nb::module_& module) {
    nb::class_<StippleOptions>(module, "StippleOptions")
        .def(nb::init<>())
        .def_rw("request", &StippleOptions::request)
        .def_rw("tone", &StippleOptions::tone)
        .def_rw("relax", &StippleOptions::relax, nb::arg().none())
        .def_rw("inks", &StippleOptions::inks)
        .def_rw("black_ink", &StippleOptions::black_ink, nb::arg().none())
        .def_rw("ink_counts", &StippleOptions::ink_counts)
        .def_rw("size_by_tone", &StippleOptions::size_by_tone)
        .def_rw("keep_inside", &StippleOptions::keep_inside)
        .def_prop_rw(
            "start", [](const StippleOptions&) { return nb::none(); },
            [](StippleOptions& options, const std::string& name) {
                options.start = named<Mode>(name, "mode");
            })
        .def_prop_rw(
            "metric", [](const StippleOptions&) { return nb::none(); },
            [](StippleOptions& options, const std::string& name) {
                options.metric = named<Metric>(name, "metric");
            });
}

}  // namespace

void add_stippling(nb::module_& module) {
    nb::class_<Ink>(module, "Ink")
        .def(nb::init<std::string, std::array<std::uint8_t, 3>>())
        .def_ro("name", &Ink::name)
        .def_prop_ro("hex", [](const Ink& ink) { return files::hex_of(ink.colour); });
    module.def("inks_of", inks_of);
    nb::class_<Picture>(module, "Picture")
        .def("__init__", [](Picture* self, const nb::bytes& content) {
            new (self) Picture{bytes_of(content), "image"};
        });
    module.def("read_picture", read_file);
    add_options(module);
    module.def("stipple", stipple_picture, nb::arg(), nb::arg(), nb::arg().none());
}

}  // namespace lacuna::python
