// locate in space: a draw becomes a random position in its bin.
#include "bodies/common/dialect.h"
KERNEL(locate_in_space, serve_locate_in_space, DrawArguments, LOCATE_IN_SPACE_BINDINGS)
#include "bodies/space/locate_in_space.h"
