// move of relax: sites move towards their centres of mass.
#include "bodies/common/prelude.h"
KERNEL(move, serve_move, SiteArguments, MOVE_BINDINGS)
#include "bodies/relax/move.h"
