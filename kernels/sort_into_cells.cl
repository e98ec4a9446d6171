// sort_into_cells of relax's descent: samples in the order of their cells.
#include "bodies/common/dialect.h"
KERNEL(sort_into_cells, serve_sort_into_cells, DescentArguments, SORT_INTO_CELLS_BINDINGS)
#include "bodies/relax/sort_into_cells.h"
