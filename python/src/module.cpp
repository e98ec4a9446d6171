// lacuna._core: the library for python/lacuna, which checks the types and shapes of all arguments.
// The library checks their values.
#include <lacuna/lacuna.h>
#include <lacuna/version.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <vector>

#include "parts.h"

namespace nb = nanobind;

namespace lacuna::python {
namespace {

nb::list list_devices() {
    std::vector<Device> all;
    {
        const nb::gil_scoped_release no_gil;
        all = devices();
    }
    nb::list entries;
    for (const Device& device : all)
        entries.append(nb::make_tuple(device.backend, device.name, device.kind, device.memory_bytes,
                                      device.largest_buffer_bytes, device.unusable));
    return entries;
}

}  // namespace
}  // namespace lacuna::python

NB_MODULE(_core, module) {
    namespace python = lacuna::python;
    module.attr("version") = LACUNA_VERSION;
    python::add_errors(module);
    python::add_options(module);
    python::add_sampling(module);
    python::add_stippling(module);
    python::add_files(module);
    python::add_domains(module);
    python::add_judging(module);
    python::add_space(module);
    module.def("devices", python::list_devices);
}
