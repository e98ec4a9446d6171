// kernels/tell_owners.cl as a compute shader in GLSL.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "tell_owners.cl"
