// enlist: adds the round's samples to the neighbour lists.
#include "bodies/common/dialect.h"
KERNEL(enlist, serve_enlist, DrawArguments, ENLIST_BINDINGS)
#include "bodies/exact/enlist.h"
