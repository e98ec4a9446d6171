// --columns: numbers that each point has besides, at random, such as how it is turned.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "cli/reports/output.h"
#include "files/point_files.h"

namespace lacuna::cli {

struct RandomColumn {
    const char* name;
    double least;
    double most;
    std::uint32_t stream;  // of random numbers, which no sampler and no other column uses
};

// angle, or size, or size:LEAST..MOST, with commas between them. Throws BadRequest, also for an
// output that has no place for them.
std::vector<RandomColumn> read_columns(const std::string& text, const std::vector<Output>& outputs);

// The numbers of this many points: those of a point follow from the seed and its place.
std::vector<files::Column> values_of(const std::vector<RandomColumn>& columns, std::uint64_t seed,
                                     std::size_t points);

}  // namespace lacuna::cli
