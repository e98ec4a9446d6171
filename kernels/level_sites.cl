// level_sites of relax: a level of the tree over the sites.
#include "bodies/common/dialect.h"
KERNEL(level_sites, serve_level_sites, SiteArguments, LEVEL_SITES_BINDINGS)
#include "bodies/relax/level_sites.h"
