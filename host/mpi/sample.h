// The command `lacuna-mpi sample`.
#pragma once

#include "cli/app_fwd.h"
#include "mpi/endings.h"

namespace lacuna::mpi {

// Adds it. `program` gives the address of the program, once there is one.
void add_sample(CLI::App& app, const MpiProgram* const& program);

}  // namespace lacuna::mpi
