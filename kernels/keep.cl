// keep: writes the pieces that cut has counted.
#include "bodies/common/dialect.h"
KERNEL(keep, serve_keep, StripArguments, KEEP_BINDINGS)
#include "bodies/exact/grid.h"
#include "bodies/exact/pieces.h"
#include "bodies/exact/keep.h"
