// locate: a draw becomes a candidate.
#include "bodies/common/prelude.h"

BINDINGS(SlabArguments, LOCATE_BINDINGS)
#include "bodies/lines/free_spans.h"
#include "bodies/common/locate.h"
ENTRY(locate, serve_locate, SlabArguments, LOCATE_BINDINGS)

BINDINGS(DrawArguments, LOCATE_IN_BOXES_BINDINGS)
#include "bodies/exact/locate_in_boxes.h"
ENTRY(locate_in_boxes, serve_locate_in_boxes, DrawArguments, LOCATE_IN_BOXES_BINDINGS)
