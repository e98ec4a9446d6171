// screen in exact: the candidates that samples in the grid cover.
#include "bodies/common/dialect.h"
KERNEL(screen, serve_screen, DrawArguments, SCREEN_BINDINGS)
#include "bodies/exact/covered_in_grid.h"
#include "bodies/common/screen.h"
