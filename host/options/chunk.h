// --chunk and --chunk-size: a chunk of the plane.
#pragma once

#include <lacuna/many.h>

#include <optional>
#include <string>

#include "options/targets.h"

namespace lacuna::options {

struct ChunkOptions {
    std::string at;  // I,J; empty: not given
    double size = 0;
};

Targets targets_of(ChunkOptions& options);

// The request of the chunk, if there is one. Throws BadRequest, and what sample() throws.
std::optional<Chunk> chunk_of(const ChunkOptions& options, const Request& request);

}  // namespace lacuna::options
