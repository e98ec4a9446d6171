// locate in mode cells: a draw on a line of the lattice becomes a candidate.
#include "bodies/common/dialect.h"
KERNEL(locate_in_cells, serve_locate_in_cells, SlabArguments, LOCATE_IN_CELLS_BINDINGS)
#include "bodies/cells/locate_in_cells.h"
