// admit on a ground: a candidate becomes a sample unless an earlier sample is closer than the
// smaller of both radii.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/prelude.h"

#ifdef ENTRY_screen_on_ground
BINDINGS(DrawArguments, SCREEN_ON_GROUND_BINDINGS)
#include "bodies/screen_on_ground.h"
ENTRY(screen_on_ground, serve_screen_on_ground, DrawArguments, SCREEN_ON_GROUND_BINDINGS)
#endif

#ifdef ENTRY_reach
BINDINGS(DrawArguments, REACH_BINDINGS)
#include "bodies/reach.h"
ENTRY(reach, serve_reach, DrawArguments, REACH_BINDINGS)
#endif

#ifdef ENTRY_admit_on_ground
BINDINGS(DrawArguments, ADMIT_ON_GROUND_BINDINGS)
#include "bodies/decide_on_ground.h"
#include "bodies/admit.h"
ENTRY(admit_on_ground, serve_admit, DrawArguments, ADMIT_ON_GROUND_BINDINGS)
#endif

#ifdef ENTRY_enlist
BINDINGS(DrawArguments, ENLIST_BINDINGS)
#include "bodies/enlist.h"
ENTRY(enlist, serve_enlist, DrawArguments, ENLIST_BINDINGS)
#endif
