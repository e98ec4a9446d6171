// locate in mode cells: a draw becomes a candidate, which has the radius of its pixel.
#include "bodies/common/prelude.h"

BINDINGS(SlabArguments, LOCATE_IN_CELLS_BINDINGS)
#include "bodies/cells/free_bits.h"
#include "bodies/common/locate.h"
ENTRY(locate_in_cells, serve_locate, SlabArguments, LOCATE_IN_CELLS_BINDINGS)

BINDINGS(DrawArguments, LOOK_UP_RADII_BINDINGS)
#include "bodies/cells/look_up_radii.h"
ENTRY(look_up_radii, serve_look_up_radii, DrawArguments, LOOK_UP_RADII_BINDINGS)
