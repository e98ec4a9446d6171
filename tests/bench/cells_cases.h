// Benchmarks of mode cells: stipples of the photograph in examples/.
#pragma once

namespace lacuna::bench {

// Adds none if the build cannot read pictures.
void add_cells_cases();

}  // namespace lacuna::bench
