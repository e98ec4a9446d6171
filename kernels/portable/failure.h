// Flags that a kernel raises if it could not finish its work.
#ifndef LACUNA_PORTABLE_FAILURE_H
#define LACUNA_PORTABLE_FAILURE_H
#include "types.h"

#define FAILED_LOCATE 1u
#define FAILED_SORT_COLUMNS 2u
#define FAILED_ADMIT 4u
#define FAILED_COLLECT 8u
#define FAILED_SUBTRACT 16u
#define FAILED_REFINE 32u
#define FAILED_CHORDS 64u   // more chords near a box than there is memory for
#define FAILED_ASSIGN 128u  // a kernel of relax
#define FAILED_DESCEND 256u

LACUNA_BEGIN

// Lavapipe grants an invocation 65,535 turns in all its loops together. After that it leaves each
// loop after one turn, without an error. This loop takes two turns, whatever `number` is: at the
// end of a kernel it shows whether all loops before it ran to their end.
LACUNA_FN bool has_turns_left(u32 number) {
    u32 rest = number | 0x80000000u;
    while (rest != 0u) rest = rest >> 16;
    return rest == 0u;
}

LACUNA_END

#endif
