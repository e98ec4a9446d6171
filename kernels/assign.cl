// assign of relax: each lattice point's mass goes to the site of least power.
#include "bodies/common/dialect.h"
KERNEL(assign, serve_assign, LeafArguments, ASSIGN_BINDINGS)
#include "bodies/relax/assign.h"
