// find_cells of relax's descent: how many samples each cell has.
#include "bodies/common/dialect.h"
KERNEL(find_cells, serve_find_cells, DescentArguments, FIND_CELLS_BINDINGS)
#include "bodies/relax/find_cells.h"
