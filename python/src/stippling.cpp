// Stippled pictures.
#include <lacuna/stipple.h>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "files/point_files.h"
#include "options.h"
#include "options/options.h"
#include "options/read.h"
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

StippleOptions options_of(const nb::dict& given, const std::vector<Ink>& inks) {
    StippleOptions options{.request = request_of(given), .inks = inks};
    read(given, options::targets_of(options));
    read(given, "ink_counts", options.ink_counts);
    read(given, "sharpen", options.tone.sharpen);
    read(given, "sharpen_amount", options.tone.sharpen_amount);
    // The library cannot refuse these: some have one member, and some are nothing without others.
    std::vector<options::GivenOption> all;
    for (const char* const name :
         {"dot-size", "pens", "pen", "dot-style", "paper-size", "margin"}) {
        const std::string argument = options::find_option(options::kStipple, name)->key();
        if (given.contains(argument.c_str()))
            all.push_back({name, {nb::cast<std::string>(given[argument.c_str()])}});
    }
    options::refuse_pairs(options::kStipple, all);
    return options;
}

// The dots of a picture as attributes of a Stippling.
nb::dict stipple_picture(const Picture& picture, const nb::dict& given,
                         const std::vector<Ink>& inks, const std::optional<PointArray>& start,
                         nb::object progress) {
    StippleOptions options = options_of(given, inks);
    if (start) options.start_points = points_of(*start);
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
    const Field picture_field;  // stands for the picture's: sizes are scales
    dots.request.field = &picture_field;
    nb::dict made = dict_of(std::move(dots.result), dots.request, dots.relaxed);
    made["radii"] = array_of(std::move(dots.diameters));
    if (!dots.ellipses.empty()) made["ellipses"] = array_of(std::move(dots.ellipses));
    made["ink"] = dots.layers.empty() ? nb::object(nb::none()) : array_of(std::move(ink));
    nb::list inks_or_pens;
    for (const Layer& layer : dots.layers) inks_or_pens.append(layer.ink);
    made["layers"] = inks_or_pens;
    if (dots.paper) {
        const Paper& paper = *dots.paper;
        made["paper"] = nb::make_tuple(paper.width_mm, paper.height_mm, paper.margin_mm);
    }
    made["are_strokes"] = dots.are_strokes;
    made["pen_mm"] = dots.pen_mm;
    made["circles"] = dots.circles;
    made["line_width"] = dots.line_width;
    made["for_a_pen"] = dots.is_for_a_pen;
    made["path_length"] = dots.path_length;
    made["plot_seconds"] = dots.plot_seconds;
    nb::list plots;
    for (const auto& [length, seconds] : dots.layer_plots)
        plots.append(nb::make_tuple(length, seconds));
    made["layer_plots"] = nb::tuple(plots);
    made["iterations"] = dots.iterations;
    made["seconds"] = watch.seconds();
    return made;
}

}  // namespace

void add_stippling(nb::module_& module) {
    nb::class_<Ink>(module, "Ink")
        .def(nb::init<std::string, std::array<std::uint8_t, 3>, double>())
        .def_ro("name", &Ink::name)
        .def_ro("pen_mm", &Ink::pen_mm)
        .def_prop_ro("hex", [](const Ink& ink) { return files::hex_of(ink.colour); });
    module.def("inks_of", inks_of);
    nb::class_<Picture>(module, "Picture")
        .def("__init__", [](Picture* self, const nb::bytes& content) {
            new (self) Picture{bytes_of(content), "image"};
        });
    module.def("read_picture", read_file);
    module.def("stipple", stipple_picture, nb::arg(), nb::arg(), nb::arg(), nb::arg().none(),
               nb::arg().none());
}

}  // namespace lacuna::python
