// Pictures in several inks.
#include <lacuna/inks.h>
#include <lacuna/pictures.h>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "arrays.h"
#include "files/point_files.h"
#include "parts.h"
#include "watch.h"

namespace nb = nanobind;

namespace lacuna::python {
namespace {

std::vector<Field> read_separated(const nb::bytes& bytes, const std::vector<Ink>& inks,
                                  const Tone& tone, double black_ink) {
    const std::string path(bytes.c_str(), bytes.size());
    const Unlocked unlocked;
    return read_inks(path, inks, tone, black_ink);
}

std::vector<Field> decode_separated(const nb::bytes& bytes, const std::string& name,
                                    const std::vector<Ink>& inks, const Tone& tone,
                                    double black_ink) {
    const std::string_view content(static_cast<const char*>(bytes.data()), bytes.size());
    const Unlocked unlocked;
    return decode_inks(content, name, inks, tone, black_ink);
}

nb::dict place(const std::vector<Field*>& fields, const std::vector<std::uint64_t>& dots,
               std::uint64_t seed, const RelaxOptions& options, nb::object progress) {
    Watch watch(std::move(progress));
    std::vector<InkPart> inks;
    for (std::size_t k = 0; k < fields.size(); ++k) inks.push_back({fields[k], dots[k]});
    InkDots placed;
    {
        const nb::gil_scoped_release no_gil;
        placed = place_inks(inks, seed, options, watch);
    }
    nb::dict made;
    made["points"] = array_of(std::move(placed.points));
    made["lattice"] = nb::make_tuple(placed.lattice_columns, placed.lattice_rows);
    made["backend"] = placed.backend;
    made["device"] = placed.device;
    made["seconds"] = watch.seconds();
    return made;
}

}  // namespace

void add_inks(nb::module_& module) {
    nb::class_<Ink>(module, "Ink")
        .def(nb::init<std::string, std::array<std::uint8_t, 3>>())
        .def_ro("name", &Ink::name)
        .def_prop_ro("hex", [](const Ink& ink) { return files::hex_of(ink.colour); });
    module.attr("black_ink") = kBlackInk;
    module.def("inks_of", inks_of);
    module.def("read_inks", read_separated);
    module.def("decode_inks", decode_separated);
    module.def("dots_by_ink", [](std::uint64_t dots, const std::vector<Field*>& inks) {
        const Unlocked unlocked;
        std::vector<Field> fields;
        for (const Field* field : inks) fields.push_back(*field);
        return dots_by_ink(dots, fields);
    });
    module.def("place_inks", place, nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg().none());
}

}  // namespace lacuna::python
