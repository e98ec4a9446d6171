// move of relax: samples move to their centres of mass, and the tree over them follows.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/common/prelude.h"

#ifdef ENTRY_move
BINDINGS(SiteArguments, MOVE_BINDINGS)
#include "bodies/relax/move.h"
ENTRY(move, serve_move, SiteArguments, MOVE_BINDINGS)
#endif

#ifdef ENTRY_find_least
BINDINGS(SiteArguments, FIND_LEAST_BINDINGS)
#include "bodies/relax/find_least.h"
ENTRY(find_least, serve_find_least, SiteArguments, FIND_LEAST_BINDINGS)
#endif

#ifdef ENTRY_level_sites
BINDINGS(SiteArguments, LEVEL_SITES_BINDINGS)
#include "bodies/relax/level_sites.h"
ENTRY(level_sites, serve_level_sites, SiteArguments, LEVEL_SITES_BINDINGS)
#endif
