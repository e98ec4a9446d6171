// Where the samples of a cell begin: the sums of scan.
#include "bodies/common/sums.h"

BODY u32 cell_begin(MEMORY const DescentArguments a, const u32 cell) {
    return sum_before(ON cell, a.block_bits);
}
