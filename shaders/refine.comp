// refine: what all samples leave of the boxes (docs/design.md, section 4, "exact").
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/common/prelude.h"

#ifdef ENTRY_insert
BINDINGS(DrawArguments, INSERT_BINDINGS)
#include "bodies/common/insert.h"
ENTRY(insert, serve_insert, DrawArguments, INSERT_BINDINGS)
#endif

#ifdef ENTRY_unfold
BINDINGS(SlabArguments, UNFOLD_BINDINGS)
#include "bodies/exact/unfold.h"
ENTRY(unfold, serve_unfold, SlabArguments, UNFOLD_BINDINGS)
#endif

#ifdef ENTRY_cut
BINDINGS(StripArguments, CUT_BINDINGS)
#include "bodies/exact/grid.h"
#include "bodies/exact/pieces.h"
#include "bodies/exact/cut.h"
ENTRY(cut, serve_cut, StripArguments, CUT_BINDINGS)
#endif

#ifdef ENTRY_keep
BINDINGS(StripArguments, KEEP_BINDINGS)
#include "bodies/exact/grid.h"
#include "bodies/exact/pieces.h"
#include "bodies/exact/keep.h"
ENTRY(keep, serve_keep, StripArguments, KEEP_BINDINGS)
#endif

#ifdef ENTRY_find_bin_begins
BINDINGS(ColumnArguments, FIND_BIN_BEGINS_BINDINGS)
#include "bodies/common/find_bin_begins.h"
ENTRY(find_bin_begins, serve_find_bin_begins, ColumnArguments, FIND_BIN_BEGINS_BINDINGS)
#endif
