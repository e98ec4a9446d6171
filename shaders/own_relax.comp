// own and gather of relax: each lattice point's mass goes to the sample of least power.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/prelude.h"

#ifdef ENTRY_find_hints
BINDINGS(LeafArguments, FIND_HINTS_BINDINGS)
#include "bodies/find_hints.h"
ENTRY(find_hints, serve_find_hints, LeafArguments, FIND_HINTS_BINDINGS)
#endif

#ifdef ENTRY_find_rivals
BINDINGS(LeafArguments, FIND_RIVALS_BINDINGS)
#include "bodies/find_rivals.h"
ENTRY(find_rivals, serve_find_rivals, LeafArguments, FIND_RIVALS_BINDINGS)
#endif

#ifdef ENTRY_own
BINDINGS(LeafArguments, OWN_BINDINGS)
#include "bodies/own.h"
ENTRY(own, serve_own, LeafArguments, OWN_BINDINGS)
#endif

#ifdef ENTRY_tell_owners
BINDINGS(LeafArguments, TELL_OWNERS_BINDINGS)
#include "bodies/tell_owners.h"
ENTRY(tell_owners, serve_tell_owners, LeafArguments, TELL_OWNERS_BINDINGS)
#endif

#ifdef ENTRY_own_crowded
BINDINGS(LeafArguments, OWN_CROWDED_BINDINGS)
#include "bodies/own_crowded.h"
ENTRY(own_crowded, serve_own_crowded, LeafArguments, OWN_CROWDED_BINDINGS)
#endif
