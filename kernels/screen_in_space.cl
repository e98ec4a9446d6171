// screen in space: decides the draws that samples around them cover.
#include "bodies/common/dialect.h"
KERNEL(screen_in_space, serve_screen, DrawArguments, SCREEN_IN_SPACE_BINDINGS)
#include "bodies/space/covered_in_space.h"
#include "bodies/common/screen.h"
