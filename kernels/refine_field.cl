// refine with a radius field: what the samples in the lists of their blocks leave of the boxes
// (docs/design.md, section 4).
#include "bodies/common/prelude.h"

BINDINGS(StripArguments, SPLIT_BINDINGS)
#include "bodies/exact/radius_field.h"
#include "bodies/exact/split.h"
ENTRY(split, serve_split, StripArguments, SPLIT_BINDINGS)

BINDINGS(StripArguments, CUT_WITH_FIELD_BINDINGS)
#include "bodies/exact/lists.h"
#include "bodies/exact/pieces.h"
#include "bodies/exact/cut.h"
ENTRY(cut_with_field, serve_cut, StripArguments, CUT_WITH_FIELD_BINDINGS)

BINDINGS(StripArguments, KEEP_WITH_FIELD_BINDINGS)
#include "bodies/exact/lists.h"
#include "bodies/exact/pieces.h"
#include "bodies/exact/keep.h"
ENTRY(keep_with_field, serve_keep, StripArguments, KEEP_WITH_FIELD_BINDINGS)

BINDINGS(StripArguments, MEASURE_BINDINGS)
#include "bodies/exact/radius_field.h"
#include "bodies/exact/measure.h"
ENTRY(measure, serve_measure, StripArguments, MEASURE_BINDINGS)
