// refine: what all samples leave of the boxes (docs/design.md, section 4, "exact").
#include "bodies/common/prelude.h"

BINDINGS(DrawArguments, INSERT_BINDINGS)
#include "bodies/common/insert.h"
ENTRY(insert, serve_insert, DrawArguments, INSERT_BINDINGS)

BINDINGS(SlabArguments, UNFOLD_BINDINGS)
#include "bodies/exact/unfold.h"
ENTRY(unfold, serve_unfold, SlabArguments, UNFOLD_BINDINGS)

BINDINGS(StripArguments, CUT_BINDINGS)
#include "bodies/exact/grid.h"
#include "bodies/exact/pieces.h"
#include "bodies/exact/cut.h"
ENTRY(cut, serve_cut, StripArguments, CUT_BINDINGS)

BINDINGS(StripArguments, KEEP_BINDINGS)
#include "bodies/exact/grid.h"
#include "bodies/exact/pieces.h"
#include "bodies/exact/keep.h"
ENTRY(keep, serve_keep, StripArguments, KEEP_BINDINGS)

BINDINGS(ColumnArguments, FIND_BIN_BEGINS_BINDINGS)
#include "bodies/common/find_bin_begins.h"
ENTRY(find_bin_begins, serve_find_bin_begins, ColumnArguments, FIND_BIN_BEGINS_BINDINGS)
