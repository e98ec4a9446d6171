// insert: puts the round's samples into the sample grid.
#include "bodies/common/dialect.h"
KERNEL(insert, serve_insert, DrawArguments, INSERT_BINDINGS)
#include "bodies/common/insert.h"
