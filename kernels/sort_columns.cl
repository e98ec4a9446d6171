// sort_columns: the order of y within each column of candidates, in every mode.
#include "bodies/common/prelude.h"
KERNEL(sort_columns, serve_sort_columns, ColumnArguments, SORT_COLUMNS_BINDINGS)
#include "bodies/common/sort_columns.h"
