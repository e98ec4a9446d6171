// screen with a radius field: the candidates that samples in neighbour lists cover.
#include "bodies/common/dialect.h"
KERNEL(screen_with_field, serve_screen, DrawArguments, SCREEN_WITH_FIELD_BINDINGS)
#include "bodies/exact/covered_in_lists.h"
#include "bodies/common/screen.h"
