// `lacuna sample --seeds A..B`: a set for each seed, and a file for each set.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "cli/app_fwd.h"
#include "cli/options/common_options.h"
#include "cli/options/drawing.h"

namespace lacuna::cli {

struct SeedRange {
    std::uint64_t first;
    std::uint64_t last;  // included
};

// Adds --seeds; `seeds` must outlive the command.
void add_seeds(CLI::App& command, std::optional<SeedRange>& seeds);

// Makes the sets and writes each to every output, whose name must have {seed} in it. Every file has
// the same bytes as with --seed. `more` is added to the origin that files hold. Throws what
// lacuna::sample and the files throw.
void sample_seeds(const CLI::App& command, const CommonOptions& options,
                  const DrawingOptions& drawing, SeedRange seeds,
                  const nlohmann::ordered_json& more);

}  // namespace lacuna::cli
