// --report of lacuna-mpi: the set, and the least, median and most seconds, bytes and memory that a
// rank took.
#pragma once

#include <lacuna/lacuna.h>

#include <string>

#include "cli/terminal/observers.h"
#include "mpi/mpi_ranks.h"
#include "mpi/npy_sink.h"
#include "ranks/sample_on_ranks.h"

namespace lacuna::mpi {

// Every rank must call it. Returns the text on rank 0, and an empty one on the others.
std::string report_of(const Request& request, const ResultOnRanks& result,
                      const cli::Stopwatch& stopwatch, double seconds, const MpiRanks& ranks,
                      const NpySink& sink, const std::string& sha256);

}  // namespace lacuna::mpi
