// locate in modes lines and exact: a draw on a line becomes a candidate.
#include "bodies/common/dialect.h"
KERNEL(locate, serve_locate, SlabArguments, LOCATE_BINDINGS)
#include "bodies/lines/locate.h"
