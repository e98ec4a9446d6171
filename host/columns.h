// How the lines are shared out: columns of lines, and where a round's draws fall among them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backend.h"
#include "plan.h"

namespace lacuna {

// Columns are at least as wide as the radius, so that all that touches a line lies in its own
// column or in the one on either side (portable/column.h).
std::uint32_t count_columns(const Plan& plan);

// begins[column] .. begins[column + 1] are the draws, or candidates, of the column. They must come
// column by column, as draws sorted by line do.
void find_column_begins(const Plan& plan, std::uint32_t columns, std::span<const Draw> draws,
                        std::vector<std::uint32_t>& begins);
void find_column_begins(const Plan& plan, std::uint32_t columns,
                        std::span<const Candidate> candidates, std::vector<std::uint32_t>& begins);

// How many free spans a line has room for at first. Few lines ever need more; those that do make
// the backend grow, and no span is lost.
std::uint32_t first_capacity(const Plan& plan);

}  // namespace lacuna
