// locate in mode cells: a draw becomes a candidate, which has the radius of its pixel.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/common/prelude.h"

#ifdef ENTRY_locate_in_cells
BINDINGS(SlabArguments, LOCATE_IN_CELLS_BINDINGS)
#include "bodies/cells/free_bits.h"
#include "bodies/common/locate.h"
ENTRY(locate_in_cells, serve_locate, SlabArguments, LOCATE_IN_CELLS_BINDINGS)
#endif

#ifdef ENTRY_look_up_radii
BINDINGS(DrawArguments, LOOK_UP_RADII_BINDINGS)
#include "bodies/cells/look_up_radii.h"
ENTRY(look_up_radii, serve_look_up_radii, DrawArguments, LOOK_UP_RADII_BINDINGS)
#endif
