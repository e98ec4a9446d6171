// `lacuna sample --seeds A..B`: a set a seed, a file a set.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "cli/app_fwd.h"
#include "cli/options/common_options.h"
#include "cli/options/drawing.h"
#include "cli/options/given_files.h"
#include "cli/reports/output.h"

namespace lacuna::cli {

struct SeedRange {
    std::uint64_t first;
    std::uint64_t last;  // which is one of them
};

// --seeds; `seeds` must outlive the command.
void add_seeds(CLI::App& command, std::optional<SeedRange>& seeds);

// What the sets are written to, before the work starts: each path must have {seed} in its name, and
// the report must not, because it is one of all sets. All folders must be there and writable.
// Throws as checked_outputs of one set does, where a file of any seed is that of another, or the
// report, or one of those in `read`.
std::vector<Output> checked_outputs(const CLI::App& command, const CommonOptions& options,
                                    SeedRange seeds, const std::vector<GivenFile>& read);

// Makes the sets and writes each to `outputs`, as checked_outputs gives them. Every file has the
// bytes that --seed alone would give; `more` is told of where it comes from. Throws what
// lacuna::sample and the files throw.
void sample_seeds(const CLI::App& command, const CommonOptions& options,
                  const DrawingOptions& drawing, const std::vector<Output>& outputs,
                  SeedRange seeds, const nlohmann::ordered_json& more);

}  // namespace lacuna::cli
