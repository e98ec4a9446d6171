// find_hints of relax: a site near each leaf of the lattice.
#include "bodies/common/dialect.h"
KERNEL(find_hints, serve_find_hints, LeafArguments, FIND_HINTS_BINDINGS)
#include "bodies/relax/find_hints.h"
