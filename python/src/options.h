// Options of the library from dicts. Their keys are Python's arguments; python/lacuna has converted
// the values, and leaves out what was not given.
#pragma once

#include <lacuna/lacuna.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "options/make.h"
#include "options/targets.h"

namespace lacuna::python {

namespace nb = nanobind;

[[noreturn]] void refuse_number(const char* name, nb::handle value, std::uint64_t most);

// Throws BadRequest for a whole number that is too large for its target.
template <typename Value>
void read(const nb::dict& given, const char* name, Value& value) {
    if (!given.contains(name)) return;
    if constexpr (std::is_same_v<Value, std::uint32_t> ||
                  std::is_same_v<Value, std::optional<std::uint32_t>>) {
        constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
        const auto number = nb::cast<std::uint64_t>(given[name]);
        if (number > kMost) refuse_number(name, given[name], kMost);
        value = static_cast<std::uint32_t>(number);
    } else {
        value = nb::cast<Value>(given[name]);
    }
}

// Python's argument for an option of the library: n for count, and _ in place of -.
std::string argument_called(std::string_view option);

// Reads all options that have a target.
void read(const nb::dict& given, const options::Targets& targets);

inline Domain domain_in(const nb::dict& given) {
    Domain domain;
    if (given.contains("domain")) {
        // (width, height) or (x0, y0, x1, y1)
        const auto numbers = nb::cast<std::vector<double>>(given["domain"]);
        domain.width = numbers.at(numbers.size() - 2);
        domain.height = numbers.back();
        if (numbers.size() == 4) {
            domain.x0 = numbers[0];
            domain.y0 = numbers[1];
            domain.width -= domain.x0;
            domain.height -= domain.y0;
        }
    }
    if (given.contains("torus") && nb::cast<bool>(given["torus"]))
        domain.boundary = Boundary::torus;
    return domain;
}

inline RunOn run_on_in(const nb::dict& given) {
    RunOn run_on;
    read(given, "backend", run_on.backend);
    read(given, "device", run_on.device);
    read(given, "threads", run_on.threads);
    read(given, "memory_limit", run_on.memory_limit_bytes);
    return run_on;
}

void read_classes(const nb::dict& given, Classes& classes);
// Reads masks, borders and the edge, of all points and of classes; not outlines.
void read_places(const nb::dict& given, Places& places);

// A request without its mode, metric and arrays.
Request request_of(const nb::dict& given);

// The moves of a request.
options::Moves moves_of(const nb::dict& given);

// Throws BadRequest for arguments of sample that exclude or need each other. given["given"] lists
// those that are arrays.
void refuse_pairs(const nb::dict& given);

// The request as reports have it.
nb::dict described(const Request& request, const Result& result);

}  // namespace lacuna::python
