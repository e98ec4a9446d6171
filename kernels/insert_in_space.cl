// insert in space: puts the round's samples into the lists of their blocks.
#include "bodies/common/dialect.h"
KERNEL(insert_in_space, serve_insert, DrawArguments, INSERT_IN_SPACE_BINDINGS)
#include "bodies/space/insert_in_space.h"
#include "bodies/common/insert.h"
