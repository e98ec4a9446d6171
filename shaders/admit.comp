// admit: a candidate becomes a sample unless an earlier sample is closer than the radius.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/common/prelude.h"

#ifdef ENTRY_screen
BINDINGS(DrawArguments, SCREEN_BINDINGS)
#include "bodies/exact/screen.h"
ENTRY(screen, serve_screen, DrawArguments, SCREEN_BINDINGS)
#endif

#ifdef ENTRY_admit
BINDINGS(DrawArguments, ADMIT_BINDINGS)
#include "bodies/lines/limit.h"
#include "bodies/common/decide.h"
#include "bodies/common/admit.h"
ENTRY(admit, serve_admit, DrawArguments, ADMIT_BINDINGS)
#endif

#ifdef ENTRY_screen_on_lines
BINDINGS(SlabArguments, SCREEN_ON_LINES_BINDINGS)
#include "bodies/lines/screen_on_lines.h"
ENTRY(screen_on_lines, serve_screen_on_lines, SlabArguments, SCREEN_ON_LINES_BINDINGS)
#endif
