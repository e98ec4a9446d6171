// subtract: the chords of the round's samples, cut from the free spans of every line.
#include "bodies/prelude.h"

BINDINGS(ColumnArguments, GATHER_BINDINGS)
#include "bodies/gather.h"
ENTRY(gather, serve_gather, ColumnArguments, GATHER_BINDINGS)

BINDINGS(SlabArguments, SUBTRACT_BINDINGS)
#include "bodies/subtract.h"
ENTRY(subtract, serve_subtract, SlabArguments, SUBTRACT_BINDINGS)

BINDINGS(SlabArguments, GROW_BINDINGS)
#include "bodies/grow.h"
ENTRY(grow, serve_grow, SlabArguments, GROW_BINDINGS)
