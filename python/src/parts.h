// The parts of the module, which module.cpp combines.
#pragma once

#include <lacuna/lacuna.h>
#include <nanobind/nanobind.h>

#include <string>

namespace lacuna::python {

void add_errors(nanobind::module_& module);
void add_sampling(nanobind::module_& module);  // requests, fields, sample and relax
void add_stippling(nanobind::module_& module);
void add_files(nanobind::module_& module);    // point files and pictures
void add_domains(nanobind::module_& module);  // masks and polygons
void add_judging(nanobind::module_& module);  // verify and analyze

// The attributes of results, but for the seconds.
nanobind::dict dict_of(Result result);
nanobind::dict dict_of(Relaxed relaxed);

// The enum with this name; python/lacuna has checked the name.
template <typename Enum>
Enum named(const std::string& name, const char* option) {
    for (int i = 0; !name_of(static_cast<Enum>(i)).empty(); ++i)
        if (name_of(static_cast<Enum>(i)) == name) return static_cast<Enum>(i);
    throw BadRequest(option, name, "is not known");
}

}  // namespace lacuna::python
