// The cpu backend: the verbs on threads, a column of lines a task.
#pragma once

#include <memory>

#include "backends/backend.h"

namespace lacuna::cpu {

std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement);
// Of a plan with a radius field, which make_backend comes to by itself.
std::unique_ptr<Backend> make_field_backend(const Plan& plan, const Placement& placement);

}  // namespace lacuna::cpu
