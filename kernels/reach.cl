// reach: the blocks of first boxes that each candidate reaches.
#include "bodies/common/dialect.h"
KERNEL(reach, serve_reach, DrawArguments, REACH_BINDINGS)
#include "bodies/exact/reach.h"
