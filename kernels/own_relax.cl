// own and gather of relax: each lattice point's mass goes to the sample of least power.
#include "bodies/prelude.h"

BINDINGS(LeafArguments, FIND_HINTS_BINDINGS)
#include "bodies/find_hints.h"
ENTRY(find_hints, serve_find_hints, LeafArguments, FIND_HINTS_BINDINGS)

BINDINGS(LeafArguments, FIND_RIVALS_BINDINGS)
#include "bodies/find_rivals.h"
ENTRY(find_rivals, serve_find_rivals, LeafArguments, FIND_RIVALS_BINDINGS)

BINDINGS(LeafArguments, OWN_BINDINGS)
#include "bodies/own.h"
ENTRY(own, serve_own, LeafArguments, OWN_BINDINGS)

BINDINGS(LeafArguments, TELL_OWNERS_BINDINGS)
#include "bodies/tell_owners.h"
ENTRY(tell_owners, serve_tell_owners, LeafArguments, TELL_OWNERS_BINDINGS)

BINDINGS(LeafArguments, OWN_CROWDED_BINDINGS)
#include "bodies/own_crowded.h"
ENTRY(own_crowded, serve_own_crowded, LeafArguments, OWN_CROWDED_BINDINGS)
