// Answers every set of numbers, and notes the error of the square root's estimate.
#include "arithmetic.h"

typedef struct Arguments {
    u32 first_item;
    u32 items;
} Arguments;

#define KERNEL(name, answer)                                                     \
    kernel void name(const Arguments arguments, global const Numbers* questions, \
                     global Answers* replies, global u32* off_by) {              \
        const u32 i = arguments.first_item + (u32)get_global_id(0);              \
        if (i >= arguments.items) return;                                        \
        replies[i] = answer(questions[i]);                                       \
        const u64 estimate = sqrt_estimate(questions[i].n);                      \
        const u64 root = replies[i].root;                                        \
        off_by[i] = (u32)(estimate > root ? estimate - root : root - estimate);  \
    }

KERNEL(arithmetic, answer)
