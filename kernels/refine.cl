// refine: what all samples leave of the places, in boxes (docs/design.md, section 4, "exact").
#include "bodies/prelude.h"

BINDINGS(DrawArguments, INSERT_BINDINGS)
#include "bodies/insert.h"
ENTRY(insert, serve_insert, DrawArguments, INSERT_BINDINGS)

BINDINGS(SlabArguments, UNFOLD_BINDINGS)
#include "bodies/unfold.h"
ENTRY(unfold, serve_unfold, SlabArguments, UNFOLD_BINDINGS)

BINDINGS(StripArguments, CUT_BINDINGS)
#include "bodies/strips.h"
#include "bodies/cut.h"
ENTRY(cut, serve_cut, StripArguments, CUT_BINDINGS)

BINDINGS(StripArguments, KEEP_BINDINGS)
#include "bodies/strips.h"
#include "bodies/keep.h"
ENTRY(keep, serve_keep, StripArguments, KEEP_BINDINGS)

BINDINGS(ColumnArguments, FIND_PLACE_BEGINS_BINDINGS)
#include "bodies/find_place_begins.h"
ENTRY(find_place_begins, serve_find_place_begins, ColumnArguments, FIND_PLACE_BEGINS_BINDINGS)
