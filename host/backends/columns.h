// How the work is shared out: columns of lines, and where places and draws fall among them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "plan/plan.h"

namespace lacuna {

// Columns are at least as wide as the radius, so that all that touches a line lies in its own
// column or in the one on either side (portable/column.h).
std::uint32_t count_columns(const Plan& plan);

// The first line of every column, then the number of lines.
std::vector<std::uint32_t> first_lines(const Plan& plan, std::uint32_t columns);

// begins[column] .. begins[column + 1] are the draws of the column, whose places are
// bin_begins[column] .. bin_begins[column + 1]. The draws are sorted by place.
void find_column_begins(std::span<const std::uint32_t> bin_begins, std::span<const Draw> draws,
                        std::vector<std::uint32_t>& begins);
// The same for candidates, which come column by column.
void find_column_begins(const Plan& plan, std::uint32_t columns,
                        std::span<const Candidate> candidates, std::vector<std::uint32_t>& begins);

// How many free spans a line has room for at first. Few lines ever need more; those that do make
// the backend grow, and no span is lost.
std::uint32_t first_capacity(const Plan& plan);

}  // namespace lacuna
