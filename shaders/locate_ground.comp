// locate on a ground: a draw becomes a candidate, with the radius that its place asks for.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/prelude.h"

#ifdef ENTRY_locate_on_ground
BINDINGS(DrawArguments, LOCATE_ON_GROUND_BINDINGS)
#include "bodies/ground.h"
#include "bodies/locate_on_ground.h"
ENTRY(locate_on_ground, serve_locate_on_ground, DrawArguments, LOCATE_ON_GROUND_BINDINGS)
#endif
