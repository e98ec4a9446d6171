// How the work is divided: columns of lines, and the bins and draws of each column.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "plan/plan.h"

namespace lacuna {

// Columns are at least as wide as the radius, so that all samples that touch a line lie in its own
// column or in a neighbouring one (portable/column.h).
std::uint32_t count_columns(const Plan& plan);

// The first line of every column, then the number of lines.
std::vector<std::uint32_t> first_lines(const Plan& plan, std::uint32_t columns);

// Finds each column's draws: [begins[c], begins[c + 1]) of column c, whose bins are [bin_begins[c],
// bin_begins[c + 1]). The draws are sorted by bin.
void find_column_begins(std::span<const std::uint32_t> bin_begins, std::span<const Draw> draws,
                        std::vector<std::uint32_t>& begins);
// The same for candidates, which come column by column.
void find_column_begins(const Plan& plan, std::uint32_t columns,
                        std::span<const Candidate> candidates, std::vector<std::uint32_t>& begins);

// A round crowds if a candidate is compared with more than kMostRivals others on average: then it
// is admitted in parts (cpu/crowd.h). Comparing all pairs of kFewDraws draws takes little time.
inline constexpr std::uint32_t kMostRivals = 64;
inline constexpr std::uint32_t kFewDraws = 1024;

// The number of free spans that a line has room for at first. Few lines ever need more; then the
// backend grows, and no span is lost.
std::uint32_t first_capacity(const Plan& plan);

}  // namespace lacuna
