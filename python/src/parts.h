// The parts of the module, which module.cpp combines.
#pragma once

#include <nanobind/nanobind.h>

namespace lacuna::python {

void add_errors(nanobind::module_& module);
void add_sampling(nanobind::module_& module);  // requests, fields, sample and relax
void add_inks(nanobind::module_& module);      // pictures in several inks
void add_files(nanobind::module_& module);     // point files and pictures
void add_domains(nanobind::module_& module);   // masks and polygons
void add_judging(nanobind::module_& module);   // verify and analyze

}  // namespace lacuna::python
