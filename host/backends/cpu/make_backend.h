// The cpu backend: the verbs on threads, a column of lines a task.
#pragma once

#include <memory>

#include "backends/backend.h"

namespace lacuna::cpu {

std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement);
// For plans with a radius field, for which make_backend calls it.
std::unique_ptr<Backend> make_field_backend(const Plan& plan, const Placement& placement);

}  // namespace lacuna::cpu
