// kernels/keep_with_field.cl as a compute shader in GLSL.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "keep_with_field.cl"
