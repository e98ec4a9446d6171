// admit: a candidate becomes a sample unless an earlier sample is closer than the radius.
#include "bodies/prelude.h"

BINDINGS(DrawArguments, SCREEN_BINDINGS)
#include "bodies/screen.h"
ENTRY(screen, serve_screen, DrawArguments, SCREEN_BINDINGS)

BINDINGS(DrawArguments, ADMIT_BINDINGS)
#include "bodies/limit.h"
#include "bodies/decide.h"
#include "bodies/admit.h"
ENTRY(admit, serve_admit, DrawArguments, ADMIT_BINDINGS)

BINDINGS(SlabArguments, SCREEN_ON_LINES_BINDINGS)
#include "bodies/screen_on_lines.h"
ENTRY(screen_on_lines, serve_screen_on_lines, SlabArguments, SCREEN_ON_LINES_BINDINGS)
