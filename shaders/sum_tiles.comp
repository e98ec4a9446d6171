// kernels/sum_tiles.cl as a compute shader in GLSL.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "sum_tiles.cl"
