// subtract: the chords of the round's samples, cut from the free spans of every line.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/prelude.h"

#ifdef ENTRY_gather
BINDINGS(ColumnArguments, GATHER_BINDINGS)
#include "bodies/gather.h"
ENTRY(gather, serve_gather, ColumnArguments, GATHER_BINDINGS)
#endif

#ifdef ENTRY_subtract
BINDINGS(SlabArguments, SUBTRACT_BINDINGS)
#include "bodies/subtract.h"
ENTRY(subtract, serve_subtract, SlabArguments, SUBTRACT_BINDINGS)
#endif

#ifdef ENTRY_grow
BINDINGS(SlabArguments, GROW_BINDINGS)
#include "bodies/grow.h"
ENTRY(grow, serve_grow, SlabArguments, GROW_BINDINGS)
#endif
