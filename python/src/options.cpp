// Options of requests from dicts, by the table of options.
#include "options.h"

#include <nanobind/stl/string_view.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "base/number_text.h"
#include "options/describe.h"
#include "options/options.h"
#include "options/words.h"
#include "parts.h"

namespace lacuna::python {
namespace {

using options::Kind;
using options::Option;

// Reads a value into its target. Functions are for texts: where Python has an array, it is not
// among the values given.
struct Reader {
    const nb::dict& given;
    const char* name;

    template <class Value>
    void operator()(Value* value) const {
        read(given, name, *value);
    }
    void operator()(Boundary* boundary) const {
        *boundary = nb::cast<bool>(given[name]) ? Boundary::torus : Boundary::box;
    }
    void operator()(std::optional<Mode>* mode) const { word(options::Words::modes, *mode); }
    void operator()(std::optional<Metric>* metric) const { word(options::Words::metrics, *metric); }
    void operator()(const options::Take& take) const {
        if (nb::isinstance<nb::str>(given[name]))
            take.read(nb::cast<std::string>(given[name]), take.to);
    }

    template <class Enum>
    void word(options::Words words, std::optional<Enum>& value) const {
        const auto text = nb::cast<std::string>(given[name]);
        value = options::named<Enum>(text);
        if (!value) throw BadRequest(name, "'" + text + "'", "must be " + listed(words));
    }
};

std::string text_of(const nb::handle value) {
    if (nb::isinstance<nb::float_>(value)) return shortest(nb::cast<double>(value));
    return nb::cast<std::string>(nb::str(value));
}

// How Python converts the values of options: their kinds in the table.
nb::dict kinds_of_options() {
    nb::dict kinds;
    for (const options::Commands command : {options::kSample, options::kStipple, options::kRelax,
                                            options::kVerify, options::kAnalyze})
        for (const Option* option : options::options_of(command)) {
            const nb::str name(argument_called(option->name).c_str());
            if (option->kind == Kind::number) kinds[name] = "real";
            if (option->kind == Kind::whole) kinds[name] = "whole";
            if (option->kind == Kind::flag) kinds[name] = "flag";
            if (option->kind == Kind::word) kinds[name] = "text";
        }
    return kinds;
}

}  // namespace

std::string argument_called(std::string_view option) {
    if (option == "count") return "n";
    if (option == "class") return "classes";
    if (option == "sets") return "points";
    std::string name(option);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

void refuse_number(const char* name, const nb::handle value, std::uint64_t most) {
    throw BadRequest(name, text_of(value), "must be 0 to " + std::to_string(most));
}

void read(const nb::dict& given, const options::Targets& targets) {
    for (const options::Commands command : {options::kSample, options::kStipple})
        for (const Option* option : options::options_of(command)) {
            const std::string name = argument_called(option->name);
            const auto target = targets.find(option->name);
            if (target != targets.end() && given.contains(name.c_str()))
                std::visit(Reader{given, name.c_str()}, target->second);
        }
}

Request request_of(const nb::dict& given) {
    Request request;
    read(given, options::targets_of(request));
    request.domain = domain_in(given);
    read_classes(given, request.classes);
    read_places(given, request.places);
    request.run_on = run_on_in(given);
    return request;
}

options::Moves moves_of(const nb::dict& given) {
    options::Moves moves;
    read(given, options::targets_of(moves));
    return moves;
}

void refuse_pairs(const nb::dict& given) {
    std::vector<options::GivenOption> all;
    const auto arrays = nb::cast<std::vector<std::string>>(given["given"]);
    for (const Option* option : options::options_of(options::kSample)) {
        const std::string name = argument_called(option->name);
        const bool is_array = std::find(arrays.begin(), arrays.end(), name) != arrays.end();
        if (!is_array &&
            (!given.contains(name.c_str()) || given[name.c_str()].is(nb::handle(Py_False))))
            continue;
        all.push_back({option->name});
        if (!is_array && option->kind != Kind::flag)
            all.back().values.push_back(text_of(given[name.c_str()]));
    }
    options::refuse_pairs(options::kSample, all);
}

nb::dict described(const Request& request, const Result& result) {
    nb::dict told;
    for (const auto& part : {options::describe(request, result), options::describe_place(request)})
        for (const auto& [name, value] : part)
            std::visit(
                [&, key = nb::str(name.c_str())](const auto& one) {
                    if constexpr (std::is_same_v<decltype(one), const std::nullptr_t&>)
                        told[key] = nb::none();
                    else
                        told[key] = one;
                },
                value);
    return told;
}

void add_options(nb::module_& module) {
    module.def("kinds_of_options", kinds_of_options);
}

}  // namespace lacuna::python
