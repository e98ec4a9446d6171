// kernels/assign_crowded.cl as a compute shader in GLSL.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "assign_crowded.cl"
