// --report of lacuna-mpi: what was made, and what it cost the ranks: the least, the median and the
// most.
#pragma once

#include <lacuna/lacuna.h>

#include <string>

#include "cli/terminal/stopwatch.h"
#include "mpi/mpi_ranks.h"
#include "mpi/npy_sink.h"
#include "ranks/sample_on_ranks.h"

namespace lacuna::mpi {

// Every rank calls it; the text is rank 0's alone.
std::string report_of(const Request& request, const ResultOnRanks& result,
                      const cli::Stopwatch& stopwatch, double seconds, const MpiRanks& ranks,
                      const NpySink& sink, const std::string& sha256);

}  // namespace lacuna::mpi
