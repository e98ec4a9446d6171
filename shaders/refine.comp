// refine: what all samples leave of the places, in boxes (docs/design.md, section 4, "exact").
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/prelude.h"

#ifdef ENTRY_insert
BINDINGS(DrawArguments, INSERT_BINDINGS)
#include "bodies/insert.h"
ENTRY(insert, serve_insert, DrawArguments, INSERT_BINDINGS)
#endif

#ifdef ENTRY_unfold
BINDINGS(SlabArguments, UNFOLD_BINDINGS)
#include "bodies/unfold.h"
ENTRY(unfold, serve_unfold, SlabArguments, UNFOLD_BINDINGS)
#endif

#ifdef ENTRY_cut
BINDINGS(StripArguments, CUT_BINDINGS)
#include "bodies/strips.h"
#include "bodies/cut.h"
ENTRY(cut, serve_cut, StripArguments, CUT_BINDINGS)
#endif

#ifdef ENTRY_keep
BINDINGS(StripArguments, KEEP_BINDINGS)
#include "bodies/strips.h"
#include "bodies/keep.h"
ENTRY(keep, serve_keep, StripArguments, KEEP_BINDINGS)
#endif

#ifdef ENTRY_find_place_begins
BINDINGS(ColumnArguments, FIND_PLACE_BEGINS_BINDINGS)
#include "bodies/find_place_begins.h"
ENTRY(find_place_begins, serve_find_place_begins, ColumnArguments, FIND_PLACE_BEGINS_BINDINGS)
#endif
