// collect: the samples of the round near each tile of a column of lines.
#include "bodies/common/dialect.h"
KERNEL(collect, serve_collect, SlabArguments, COLLECT_BINDINGS)
#include "bodies/lines/collect.h"
