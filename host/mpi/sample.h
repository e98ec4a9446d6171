// The command `lacuna-mpi sample`.
#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}
#include "mpi/endings.h"

namespace lacuna::mpi {

// Adds the command to `app`. The pointer `program` must be set before the command runs.
void add_sample(CLI::App& app, const MpiProgram* const& program);

}  // namespace lacuna::mpi
