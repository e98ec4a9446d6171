// subtract: the chords of the round's samples, cut from the free spans of every line.
#include "bodies/common/prelude.h"

BINDINGS(ColumnArguments, COLLECT_BINDINGS)
#include "bodies/lines/collect.h"
ENTRY(collect, serve_collect, ColumnArguments, COLLECT_BINDINGS)

BINDINGS(SlabArguments, SUBTRACT_BINDINGS)
#include "bodies/lines/subtract.h"
ENTRY(subtract, serve_subtract, SlabArguments, SUBTRACT_BINDINGS)

BINDINGS(SlabArguments, GROW_BINDINGS)
#include "bodies/lines/grow.h"
ENTRY(grow, serve_grow, SlabArguments, GROW_BINDINGS)
