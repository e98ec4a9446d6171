// collect: the samples of the round near each tile of a column of lines.
#include "bodies/common/prelude.h"
KERNEL(collect, serve_collect, SlabArguments, COLLECT_BINDINGS)
#include "bodies/lines/collect.h"
