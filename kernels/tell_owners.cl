// tell_owners of relax: writes down the owner of each lattice point.
#include "bodies/common/dialect.h"
KERNEL(tell_owners, serve_tell_owners, LeafArguments, TELL_OWNERS_BINDINGS)
#include "bodies/relax/tell_owners.h"
