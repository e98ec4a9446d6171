// subtract in mode cells: the lattice points that the round's samples block.
#include "bodies/common/dialect.h"
KERNEL(subtract_in_cells, serve_subtract_in_cells, DrawArguments, SUBTRACT_IN_CELLS_BINDINGS)
#include "bodies/cells/subtract_in_cells.h"
