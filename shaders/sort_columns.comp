// sort_columns: the order of y within each column of candidates, in every mode.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/common/prelude.h"

#ifdef ENTRY_sort_columns
BINDINGS(ColumnArguments, SORT_COLUMNS_BINDINGS)
#include "bodies/common/sort_columns.h"
ENTRY(sort_columns, serve_sort_columns, ColumnArguments, SORT_COLUMNS_BINDINGS)
#endif
