// settle of relax: samples move to their centres of mass, and the tree over them follows.
#include "bodies/prelude.h"

BINDINGS(SiteArguments, SETTLE_BINDINGS)
#include "bodies/settle.h"
ENTRY(settle, serve_settle, SiteArguments, SETTLE_BINDINGS)

BINDINGS(SiteArguments, FIND_LEAST_BINDINGS)
#include "bodies/find_least.h"
ENTRY(find_least, serve_find_least, SiteArguments, FIND_LEAST_BINDINGS)

BINDINGS(SiteArguments, LEVEL_SITES_BINDINGS)
#include "bodies/level_sites.h"
ENTRY(level_sites, serve_level_sites, SiteArguments, LEVEL_SITES_BINDINGS)
