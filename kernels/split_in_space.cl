// split in space: which pieces of each bin no sample covers.
#include "bodies/common/dialect.h"
KERNEL(split_in_space, serve_split_in_space, StripArguments, SPLIT_IN_SPACE_BINDINGS)
#include "bodies/space/split_in_space.h"
