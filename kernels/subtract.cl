// subtract: cuts the chords of the round's samples from the free spans of every line.
#include "bodies/common/dialect.h"
KERNEL(subtract, serve_subtract, SlabArguments, SUBTRACT_BINDINGS)
#include "bodies/lines/subtract.h"
