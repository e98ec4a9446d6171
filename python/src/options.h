// Options of the library from dicts. Their keys are Python's arguments; python/lacuna has converted
// the values, and leaves out what was not given.
#pragma once

#include <lacuna/lacuna.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <optional>
#include <string>
#include <utility>

#include "recipes/make.h"

namespace lacuna::python {

namespace nb = nanobind;

template <typename Value>
void read(const nb::dict& given, const char* name, Value& value) {
    if (given.contains(name)) value = nb::cast<Value>(given[name]);
}

// The enum with this name.
template <typename Enum>
Enum named(const std::string& name, const char* option) {
    std::string allowed = "must be one of ";
    for (int i = 0; !name_of(static_cast<Enum>(i)).empty(); ++i) {
        if (name_of(static_cast<Enum>(i)) == name) return static_cast<Enum>(i);
        allowed.append(i == 0 ? "" : ", ").append(name_of(static_cast<Enum>(i)));
    }
    throw BadRequest(option, "'" + name + "'", allowed);
}

template <typename Enum>
void read_word(const nb::dict& given, const char* name, std::optional<Enum>& value) {
    if (given.contains(name)) value = named<Enum>(nb::cast<std::string>(given[name]), name);
}

template <typename Options>
void read_domain(const nb::dict& given, Options& options) {
    if (given.contains("domain")) {
        const auto [width, height] = nb::cast<std::pair<double, double>>(given["domain"]);
        options.width = width;
        options.height = height;
    }
    if (given.contains("torus") && nb::cast<bool>(given["torus"]))
        options.boundary = Boundary::torus;
}

// Reads where the work is done, too.
template <typename Options>
void read_place(const nb::dict& given, Options& options) {
    read_domain(given, options);
    read(given, "backend", options.backend);
    read(given, "device", options.device);
    read(given, "threads", options.threads);
}

void read_classes(const nb::dict& given, Classes& classes);

// A request without its mode, metric and arrays.
Request request_of(const nb::dict& given);

// The moves of a request.
recipes::Moves moves_of(const nb::dict& given);

}  // namespace lacuna::python
