// subtract: the chords of the round's samples, cut from the free spans of every line.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/common/prelude.h"

#ifdef ENTRY_collect
BINDINGS(ColumnArguments, COLLECT_BINDINGS)
#include "bodies/lines/collect.h"
ENTRY(collect, serve_collect, ColumnArguments, COLLECT_BINDINGS)
#endif

#ifdef ENTRY_subtract
BINDINGS(SlabArguments, SUBTRACT_BINDINGS)
#include "bodies/lines/subtract.h"
ENTRY(subtract, serve_subtract, SlabArguments, SUBTRACT_BINDINGS)
#endif

#ifdef ENTRY_grow
BINDINGS(SlabArguments, GROW_BINDINGS)
#include "bodies/lines/grow.h"
ENTRY(grow, serve_grow, SlabArguments, GROW_BINDINGS)
#endif
