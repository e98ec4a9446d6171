// find_bin_begins: the first box of each column.
#include "bodies/common/dialect.h"
KERNEL(find_bin_begins, serve_find_bin_begins, ColumnArguments, FIND_BIN_BEGINS_BINDINGS)
#include "bodies/common/find_bin_begins.h"
