// What becomes of a candidate.
#ifndef LACUNA_PORTABLE_FATE_H
#define LACUNA_PORTABLE_FATE_H

#define FATE_UNDECIDED 0u
#define FATE_ADMITTED 1u
#define FATE_REJECTED 2u

// Stands for the sample of a draw that was rejected; no coordinate is as large.
#define NO_SAMPLE 0xffffffffu

#endif
