// cut: counts the pieces of each box that the samples in the grid leave.
#include "bodies/common/dialect.h"
KERNEL(cut, serve_cut, StripArguments, CUT_BINDINGS)
#include "bodies/exact/grid.h"
#include "bodies/exact/pieces.h"
#include "bodies/exact/cut.h"
