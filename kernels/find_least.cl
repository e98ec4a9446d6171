// find_least of relax: the least weight of all sites.
#include "bodies/common/prelude.h"
KERNEL(find_least, serve_find_least, SiteArguments, FIND_LEAST_BINDINGS)
#include "bodies/relax/find_least.h"
