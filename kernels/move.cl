// move of relax: sites move towards their centres of mass.
#include "bodies/common/dialect.h"
KERNEL(move, serve_move, SiteArguments, MOVE_BINDINGS)
#include "bodies/relax/move.h"
