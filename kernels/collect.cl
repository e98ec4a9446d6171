// collect: the samples that may cut the lines of each column.
#include "bodies/common/prelude.h"
KERNEL(collect, serve_collect, ColumnArguments, COLLECT_BINDINGS)
#include "bodies/lines/collect.h"
