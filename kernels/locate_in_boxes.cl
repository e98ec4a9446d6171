// locate in active boxes: a draw on a box becomes a candidate.
#include "bodies/common/dialect.h"
KERNEL(locate_in_boxes, serve_locate_in_boxes, DrawArguments, LOCATE_IN_BOXES_BINDINGS)
#include "bodies/exact/locate_in_boxes.h"
