// `lacuna sample --seeds A..B`: one set for each seed, one file for each set.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/common_options.h"
#include "cli/options/drawing.h"
#include "cli/options/given_files.h"
#include "cli/reports/made_set.h"
#include "cli/reports/output.h"

namespace lacuna::cli {

struct SeedRange {
    std::uint64_t first;
    std::uint64_t last;  // included
};

// FIRST..LAST. Throws BadRequest.
SeedRange read_seeds(const std::string& text);

// Checks the outputs of all seeds before the work starts, and returns them. Each path must have
// {seed} in its name; the report must not, because one report describes all sets. All folders must
// exist and be writable. Throws as checked_outputs of one set does. No file may be named for two
// seeds, for a set and the report, or in `read`.
std::vector<Output> checked_outputs(const CommonOptions& options, SeedRange seeds,
                                    const std::vector<GivenFile>& read);

// Throws BadRequest if an output has {seed} in its name, without --seeds.
void refuse_seed_in(const std::vector<std::string>& outputs, const std::string& report);

// What the files of all sets have in common.
struct AllSets {
    // Of a request as it was made: merged into the options of its origin.
    std::function<nlohmann::ordered_json(const Request& as_made)> options;
    Showing showing;
    std::optional<double> frame{};  // the width of what they share, if they are tiles
};

// Makes the sets and writes each to `outputs`, as checked_outputs gives them. Every file has the
// bytes that --seed alone would give. Throws what lacuna::sample and the files throw.
void sample_seeds(const CommandLine& line, const CommonOptions& options,
                  const DrawingOptions& drawing, const std::vector<Output>& outputs,
                  SeedRange seeds, const AllSets& all_sets);

}  // namespace lacuna::cli
