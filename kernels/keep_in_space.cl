// keep in space: writes the pieces that split has counted.
#include "bodies/common/dialect.h"
KERNEL(keep_in_space, serve_keep_in_space, StripArguments, KEEP_IN_SPACE_BINDINGS)
#include "bodies/space/keep_in_space.h"
