// locate on a ground: a draw becomes a candidate, with the radius that its place asks for.
#include "bodies/prelude.h"

BINDINGS(DrawArguments, LOCATE_ON_GROUND_BINDINGS)
#include "bodies/ground.h"
#include "bodies/locate_on_ground.h"
ENTRY(locate_on_ground, serve_locate_on_ground, DrawArguments, LOCATE_ON_GROUND_BINDINGS)
