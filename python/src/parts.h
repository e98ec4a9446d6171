// The parts of the module, which module.cpp combines.
#pragma once

#include <lacuna/lacuna.h>
#include <nanobind/nanobind.h>

#include <optional>

namespace lacuna::python {

void add_errors(nanobind::module_& module);
void add_options(nanobind::module_& module);
void add_sampling(nanobind::module_& module);  // fields, sample, sample_many, relax and order
void add_stippling(nanobind::module_& module);
void add_files(nanobind::module_& module);    // point files and pictures
void add_domains(nanobind::module_& module);  // masks and polygons
void add_judging(nanobind::module_& module);  // verify and analyze
void add_space(nanobind::module_& module);    // surfaces and volumes

// The attributes of a PointSet, but for what Python was given itself.
nanobind::dict dict_of(Result result, const Request& request, const std::optional<Relaxed>& moved);
// The attributes of a Relaxed, but for the seconds and what Python was given itself.
nanobind::dict dict_of(const Relaxed& relaxed);

}  // namespace lacuna::python
