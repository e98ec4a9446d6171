// unfold: at the first refinement, free spans become active boxes.
#include "bodies/common/dialect.h"
KERNEL(unfold, serve_unfold, SlabArguments, UNFOLD_BINDINGS)
#include "bodies/exact/unfold.h"
