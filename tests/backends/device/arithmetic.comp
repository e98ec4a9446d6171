// Answers every set of numbers, and notes the error of the square root's estimate.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#include "arithmetic.h"

layout(local_size_x_id = 0) in;

layout(push_constant) uniform Arguments {
    u32 first_item;
    u32 items;
};
layout(binding = 0) readonly restrict buffer Questions {
    Numbers questions[];
};
layout(binding = 1) writeonly restrict buffer Replies {
    Answers replies[];
};
layout(binding = 2) writeonly restrict buffer OffBy {
    u32 off_by[];
};

void main() {
    const u32 i = first_item + gl_GlobalInvocationID.x;
    if (i >= items) return;
    const Numbers q = questions[i];
    replies[i] = answer(q);
    const u64 estimate = sqrt_estimate(q.n);
    const u64 root = isqrt(q.n);
    off_by[i] = u32(estimate > root ? estimate - root : root - estimate);
}
