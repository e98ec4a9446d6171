// settle of relax: samples move to their centres of mass, and the tree over them follows.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/prelude.h"

#ifdef ENTRY_settle
BINDINGS(SiteArguments, SETTLE_BINDINGS)
#include "bodies/settle.h"
ENTRY(settle, serve_settle, SiteArguments, SETTLE_BINDINGS)
#endif

#ifdef ENTRY_find_least
BINDINGS(SiteArguments, FIND_LEAST_BINDINGS)
#include "bodies/find_least.h"
ENTRY(find_least, serve_find_least, SiteArguments, FIND_LEAST_BINDINGS)
#endif

#ifdef ENTRY_level_sites
BINDINGS(SiteArguments, LEVEL_SITES_BINDINGS)
#include "bodies/level_sites.h"
ENTRY(level_sites, serve_level_sites, SiteArguments, LEVEL_SITES_BINDINGS)
#endif
