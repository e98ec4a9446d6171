// subtract in mode cells: the lattice points that the round's samples block.
#include "bodies/prelude.h"

BINDINGS(DrawArguments, SUBTRACT_IN_CELLS_BINDINGS)
#include "bodies/subtract_in_cells.h"
ENTRY(subtract_in_cells, serve_subtract_in_cells, DrawArguments, SUBTRACT_IN_CELLS_BINDINGS)
