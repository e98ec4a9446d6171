// grow: moves spans to lines with more room.
#include "bodies/common/dialect.h"
KERNEL(grow, serve_grow, SlabArguments, GROW_BINDINGS)
#include "bodies/lines/grow.h"
