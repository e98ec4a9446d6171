// assign of relax in leaves that have too many rivals.
#include "bodies/common/dialect.h"
KERNEL(assign_crowded, serve_assign_crowded, LeafArguments, ASSIGN_CROWDED_BINDINGS)
#include "bodies/relax/assign_crowded.h"
