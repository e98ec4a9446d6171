// split: finds where boxes on unlike pixels are cut into strips.
#include "bodies/common/dialect.h"
KERNEL(split, serve_split, StripArguments, SPLIT_BINDINGS)
#include "bodies/exact/radius_field.h"
#include "bodies/exact/split.h"
