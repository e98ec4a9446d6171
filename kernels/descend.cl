// descend of relax: a step of each sample.
#include "bodies/common/dialect.h"
KERNEL(descend, serve_descend, DescentArguments, DESCEND_BINDINGS)
#include "bodies/relax/descend.h"
