// reach: the blocks of first boxes that each candidate reaches.
#include "bodies/common/prelude.h"
KERNEL(reach, serve_reach, DrawArguments, REACH_BINDINGS)
#include "bodies/exact/reach.h"
