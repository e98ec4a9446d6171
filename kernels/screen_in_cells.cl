// screen in mode cells: the candidates that samples of earlier parts block.
#include "bodies/common/dialect.h"
KERNEL(screen_in_cells, serve_screen, DrawArguments, SCREEN_IN_CELLS_BINDINGS)
#include "bodies/cells/covered_in_cells.h"
#include "bodies/common/screen.h"
