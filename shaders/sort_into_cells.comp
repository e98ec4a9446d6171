// kernels/sort_into_cells.cl as a compute shader in GLSL.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "sort_into_cells.cl"
