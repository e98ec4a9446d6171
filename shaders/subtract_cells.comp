// subtract in mode cells: the lattice points that the round's samples block.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/common/prelude.h"

#ifdef ENTRY_subtract_in_cells
BINDINGS(DrawArguments, SUBTRACT_IN_CELLS_BINDINGS)
#include "bodies/cells/subtract_in_cells.h"
ENTRY(subtract_in_cells, serve_subtract_in_cells, DrawArguments, SUBTRACT_IN_CELLS_BINDINGS)
#endif
