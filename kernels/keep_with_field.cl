// keep with a radius field: writes the pieces that cut has counted.
#include "bodies/common/dialect.h"
KERNEL(keep_with_field, serve_keep, StripArguments, KEEP_WITH_FIELD_BINDINGS)
#include "bodies/exact/lists.h"
#include "bodies/exact/pieces.h"
#include "bodies/exact/keep.h"
