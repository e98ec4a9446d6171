// cut with a radius field: counts what the samples in neighbour lists leave of each box.
#include "bodies/common/prelude.h"
KERNEL(cut_with_field, serve_cut, StripArguments, CUT_WITH_FIELD_BINDINGS)
#include "bodies/exact/lists.h"
#include "bodies/exact/pieces.h"
#include "bodies/exact/cut.h"
