// cut with a radius field: counts the pieces of each box that samples in neighbour lists leave.
#include "bodies/common/dialect.h"
KERNEL(cut_with_field, serve_cut, StripArguments, CUT_WITH_FIELD_BINDINGS)
#include "bodies/exact/lists.h"
#include "bodies/exact/pieces.h"
#include "bodies/exact/cut.h"
