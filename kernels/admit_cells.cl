// admit in mode cells: the metric of two radii says what conflicts (section 4.2.1).
#include "bodies/common/prelude.h"

BINDINGS(DrawArguments, ADMIT_IN_CELLS_BINDINGS)
#include "bodies/cells/limit_in_cells.h"
#include "bodies/common/decide.h"
#include "bodies/common/admit.h"
ENTRY(admit_in_cells, serve_admit, DrawArguments, ADMIT_IN_CELLS_BINDINGS)

BINDINGS(DrawArguments, SCREEN_IN_CELLS_BINDINGS)
#include "bodies/cells/screen_in_cells.h"
ENTRY(screen_in_cells, serve_screen_in_cells, DrawArguments, SCREEN_IN_CELLS_BINDINGS)
