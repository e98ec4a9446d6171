// A wrong admit, planted: it takes the place of shaders/admit_cells.comp and admits every candidate.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#include "portable/fate.h"
#include "portable/geometry.h"

layout(local_size_x_id = 0) in;

layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 rows; u32 metric;
                                          u32 pass; u32 draw_count; u32 chunk; };
layout(binding = 2) readonly restrict buffer Candidates { uvec4 candidates[]; };
layout(binding = 7) restrict buffer Fates { u32 fates[]; };
layout(binding = 9) writeonly restrict buffer Samples { uvec2 samples[]; };

void main() {
    const u32 begin = (first_item + gl_GlobalInvocationID.x) * chunk;
    const u32 end = min(begin + chunk, draw_count);
    for (u32 i = begin; i < end; ++i) {
        fates[i] = FATE_ADMITTED;
        samples[candidates[i].w] = candidates[i].xy;
    }
}
