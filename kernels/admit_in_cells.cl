// admit in mode cells: the metric of two radii says what conflicts (section 4.2.1).
#include "bodies/common/dialect.h"
KERNEL(admit_in_cells, serve_admit, DrawArguments, ADMIT_IN_CELLS_BINDINGS)
#include "bodies/cells/limit_in_cells.h"
#include "bodies/cells/decide_in_cells.h"
#include "bodies/common/admit.h"
