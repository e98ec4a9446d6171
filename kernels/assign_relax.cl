// assign and accumulate of relax: each lattice point's mass goes to the sample of least power.
#include "bodies/common/prelude.h"

BINDINGS(LeafArguments, FIND_HINTS_BINDINGS)
#include "bodies/relax/find_hints.h"
ENTRY(find_hints, serve_find_hints, LeafArguments, FIND_HINTS_BINDINGS)

BINDINGS(LeafArguments, FIND_RIVALS_BINDINGS)
#include "bodies/relax/find_rivals.h"
ENTRY(find_rivals, serve_find_rivals, LeafArguments, FIND_RIVALS_BINDINGS)

BINDINGS(LeafArguments, ASSIGN_BINDINGS)
#include "bodies/relax/assign.h"
ENTRY(assign, serve_assign, LeafArguments, ASSIGN_BINDINGS)

BINDINGS(LeafArguments, TELL_OWNERS_BINDINGS)
#include "bodies/relax/tell_owners.h"
ENTRY(tell_owners, serve_tell_owners, LeafArguments, TELL_OWNERS_BINDINGS)

BINDINGS(LeafArguments, ASSIGN_CROWDED_BINDINGS)
#include "bodies/relax/assign_crowded.h"
ENTRY(assign_crowded, serve_assign_crowded, LeafArguments, ASSIGN_CROWDED_BINDINGS)
