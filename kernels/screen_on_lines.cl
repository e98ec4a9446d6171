// screen in lines: the candidates that samples of earlier parts of the round cover.
#include "bodies/common/prelude.h"
KERNEL(screen_on_lines, serve_screen_on_lines, SlabArguments, SCREEN_ON_LINES_BINDINGS)
#include "bodies/lines/screen_on_lines.h"
