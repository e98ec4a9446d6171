// kernels/screen_on_lines.cl as a compute shader in GLSL.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "screen_on_lines.cl"
