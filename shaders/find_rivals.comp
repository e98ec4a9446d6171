// kernels/find_rivals.cl as a compute shader in GLSL.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "find_rivals.cl"
