// What the kernels need of the plan, passed by value: the same layout in C++, OpenCL C and GLSL.
#ifndef LACUNA_PORTABLE_GEOMETRY_H
#define LACUNA_PORTABLE_GEOMETRY_H
#include "prelude.h"

LACUNA_BEGIN

struct Geometry {
    u64 radius_squared;
    u32 radius;
    u32 width;
    u32 height;
    u32 period_x;  // the domain's width where it wraps, or 0
    u32 period_y;  // its height where it wraps, or 0
    u32 lines;
    u32 strip_width;
    u32 columns;
    u32 capacity;  // spans a line has room for
    u32 is_exact;  // 1 in mode exact, or 0
    u32 chord_margin;
    u32 grid_side;  // see sample_grid.h
    u32 grid_columns;
    u32 grid_rows;
};
LACUNA_TYPEDEF(Geometry)

LACUNA_END

#endif
