// find_rivals of relax: the sites that may own lattice points of a unit.
#include "bodies/common/dialect.h"
KERNEL(find_rivals, serve_find_rivals, LeafArguments, FIND_RIVALS_BINDINGS)
#include "bodies/relax/find_rivals.h"
