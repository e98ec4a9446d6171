// assign and accumulate of relax: each lattice point's mass goes to the sample of least power.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/common/prelude.h"

#ifdef ENTRY_find_hints
BINDINGS(LeafArguments, FIND_HINTS_BINDINGS)
#include "bodies/relax/find_hints.h"
ENTRY(find_hints, serve_find_hints, LeafArguments, FIND_HINTS_BINDINGS)
#endif

#ifdef ENTRY_find_rivals
BINDINGS(LeafArguments, FIND_RIVALS_BINDINGS)
#include "bodies/relax/find_rivals.h"
ENTRY(find_rivals, serve_find_rivals, LeafArguments, FIND_RIVALS_BINDINGS)
#endif

#ifdef ENTRY_assign
BINDINGS(LeafArguments, ASSIGN_BINDINGS)
#include "bodies/relax/assign.h"
ENTRY(assign, serve_assign, LeafArguments, ASSIGN_BINDINGS)
#endif

#ifdef ENTRY_tell_owners
BINDINGS(LeafArguments, TELL_OWNERS_BINDINGS)
#include "bodies/relax/tell_owners.h"
ENTRY(tell_owners, serve_tell_owners, LeafArguments, TELL_OWNERS_BINDINGS)
#endif

#ifdef ENTRY_assign_crowded
BINDINGS(LeafArguments, ASSIGN_CROWDED_BINDINGS)
#include "bodies/relax/assign_crowded.h"
ENTRY(assign_crowded, serve_assign_crowded, LeafArguments, ASSIGN_CROWDED_BINDINGS)
#endif
