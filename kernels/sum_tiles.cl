// sum_tiles: the free length of every line, and of its tiles from the bottom up.
#include "bodies/common/dialect.h"
KERNEL(sum_tiles, serve_sum_tiles, SlabArguments, SUM_TILES_BINDINGS)
#include "bodies/lines/sum_tiles.h"
