// open_lines: before the first round of lines and exact, all lines are free.
#include "bodies/common/dialect.h"
KERNEL(open_lines, serve_open_lines, SlabArguments, OPEN_LINES_BINDINGS)
#include "bodies/lines/open_lines.h"
