// Benchmarks of mode cells: stipples of the photograph in examples/.
#pragma once

namespace lacuna::bench {

// None where the build has no reader of pictures.
void add_cells_cases();

}  // namespace lacuna::bench
