// locate: a draw becomes a candidate; then the order of y within each column.
#include "bodies/prelude.h"

BINDINGS(SlabArguments, LOCATE_BINDINGS)
#include "bodies/locate.h"
ENTRY(locate, serve_locate, SlabArguments, LOCATE_BINDINGS)

BINDINGS(DrawArguments, LOCATE_IN_BOXES_BINDINGS)
#include "bodies/locate_in_boxes.h"
ENTRY(locate_in_boxes, serve_locate_in_boxes, DrawArguments, LOCATE_IN_BOXES_BINDINGS)

BINDINGS(ColumnArguments, SORT_COLUMNS_BINDINGS)
#include "bodies/sort_columns.h"
ENTRY(sort_columns, serve_sort_columns, ColumnArguments, SORT_COLUMNS_BINDINGS)
