// sort_columns: the order of y within each column of candidates, in mode cells.
#include "bodies/common/dialect.h"
KERNEL(sort_columns, serve_sort_columns, ColumnArguments, SORT_COLUMNS_BINDINGS)
#include "bodies/cells/sort_columns.h"
