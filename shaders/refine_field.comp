// refine with a radius field: what the samples in the lists of their blocks leave of the boxes
// (docs/design.md, section 4).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/common/prelude.h"

#ifdef ENTRY_split
BINDINGS(StripArguments, SPLIT_BINDINGS)
#include "bodies/exact/radius_field.h"
#include "bodies/exact/split.h"
ENTRY(split, serve_split, StripArguments, SPLIT_BINDINGS)
#endif

#ifdef ENTRY_cut_with_field
BINDINGS(StripArguments, CUT_WITH_FIELD_BINDINGS)
#include "bodies/exact/lists.h"
#include "bodies/exact/pieces.h"
#include "bodies/exact/cut.h"
ENTRY(cut_with_field, serve_cut, StripArguments, CUT_WITH_FIELD_BINDINGS)
#endif

#ifdef ENTRY_keep_with_field
BINDINGS(StripArguments, KEEP_WITH_FIELD_BINDINGS)
#include "bodies/exact/lists.h"
#include "bodies/exact/pieces.h"
#include "bodies/exact/keep.h"
ENTRY(keep_with_field, serve_keep, StripArguments, KEEP_WITH_FIELD_BINDINGS)
#endif

#ifdef ENTRY_measure
BINDINGS(StripArguments, MEASURE_BINDINGS)
#include "bodies/exact/radius_field.h"
#include "bodies/exact/measure.h"
ENTRY(measure, serve_measure, StripArguments, MEASURE_BINDINGS)
#endif
