// cut: counts what the samples in the grid leave of each box.
#include "bodies/common/prelude.h"
KERNEL(cut, serve_cut, StripArguments, CUT_BINDINGS)
#include "bodies/exact/grid.h"
#include "bodies/exact/pieces.h"
#include "bodies/exact/cut.h"
