// limit of relax: weights are limited by distances to the nearest sites.
#include "bodies/common/dialect.h"
KERNEL(limit, serve_limit, SiteArguments, LIMIT_BINDINGS)
#include "bodies/relax/limit.h"
