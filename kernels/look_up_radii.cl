// look_up_radii: in mode cells a candidate has the radius of its pixel.
#include "bodies/common/dialect.h"
KERNEL(look_up_radii, serve_look_up_radii, DrawArguments, LOOK_UP_RADII_BINDINGS)
#include "bodies/cells/look_up_radii.h"
