// insert: puts the round's samples into the sample grid.
#include "bodies/common/dialect.h"
KERNEL(insert, serve_insert, DrawArguments, INSERT_BINDINGS)
#include "bodies/lines/insert_in_grid.h"
#include "bodies/common/insert.h"
