// The status of a candidate.
#ifndef LACUNA_PORTABLE_STATUS_H
#define LACUNA_PORTABLE_STATUS_H

#define STATUS_UNDECIDED 0u
#define STATUS_ADMITTED 1u
#define STATUS_REJECTED 2u  // by an earlier sample of its round
#define STATUS_COVERED 3u   // by a sample of an earlier round; in exact only

// Stands for the sample of a draw that was not admitted, and of an empty cell. No coordinate is as
// large.
#define NO_SAMPLE 0xffffffffu

#endif
