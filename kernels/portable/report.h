// The words of report[], with which kernels inform each other and the host: one small transfer a
// round.
#ifndef LACUNA_PORTABLE_REPORT_H
#define LACUNA_PORTABLE_REPORT_H

// Words 0 to PASSES - 1: how many draws each pass of admit has left undecided.
#define PASSES 4u
#define FAILURE_WORD 4u     // flags of failure.h
#define OVERFLOW_WORD 5u    // 1 if a tile needs room for more spans
#define TOTAL_WORD 6u       // the sum of all counts that were scanned
#define SAMPLES_WORD 7u     // of the round
#define COVERED_WORD 8u     // draws of the round that samples of earlier rounds cover
#define LEFT_WORD 9u        // samples that the next launch of subtract_in_cells serves
#define SURVIVORS_WORD 10u  // entries of survivors[]
#define VISITORS_WORD 11u   // entries of visitors[]
#define ENTRIES_WORD 12u    // entries of the neighbour lists that the round has added
#define REPORT_WORDS 13u

#endif
