// admit with a radius field: a candidate becomes a sample unless an earlier sample is closer than the
// smaller of both radii.
#include "bodies/common/prelude.h"

BINDINGS(DrawArguments, SCREEN_WITH_FIELD_BINDINGS)
#include "bodies/exact/screen_with_field.h"
ENTRY(screen_with_field, serve_screen_with_field, DrawArguments, SCREEN_WITH_FIELD_BINDINGS)

BINDINGS(DrawArguments, REACH_BINDINGS)
#include "bodies/exact/reach.h"
ENTRY(reach, serve_reach, DrawArguments, REACH_BINDINGS)

BINDINGS(DrawArguments, ADMIT_WITH_FIELD_BINDINGS)
#include "bodies/exact/decide_with_field.h"
#include "bodies/common/admit.h"
ENTRY(admit_with_field, serve_admit, DrawArguments, ADMIT_WITH_FIELD_BINDINGS)

BINDINGS(DrawArguments, ENLIST_BINDINGS)
#include "bodies/exact/enlist.h"
ENTRY(enlist, serve_enlist, DrawArguments, ENLIST_BINDINGS)
