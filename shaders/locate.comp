// locate: a draw becomes a candidate; then the order of y within each column.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#include "bodies/prelude.h"

#ifdef ENTRY_locate
BINDINGS(SlabArguments, LOCATE_BINDINGS)
#include "bodies/locate.h"
ENTRY(locate, serve_locate, SlabArguments, LOCATE_BINDINGS)
#endif

#ifdef ENTRY_locate_in_boxes
BINDINGS(DrawArguments, LOCATE_IN_BOXES_BINDINGS)
#include "bodies/locate_in_boxes.h"
ENTRY(locate_in_boxes, serve_locate_in_boxes, DrawArguments, LOCATE_IN_BOXES_BINDINGS)
#endif

#ifdef ENTRY_sort_columns
BINDINGS(ColumnArguments, SORT_COLUMNS_BINDINGS)
#include "bodies/sort_columns.h"
ENTRY(sort_columns, serve_sort_columns, ColumnArguments, SORT_COLUMNS_BINDINGS)
#endif
