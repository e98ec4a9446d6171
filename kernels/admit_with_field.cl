// admit with a radius field: the smaller of two radii says what conflicts.
#include "bodies/common/dialect.h"
KERNEL(admit_with_field, serve_admit, DrawArguments, ADMIT_WITH_FIELD_BINDINGS)
#include "bodies/exact/decide_with_field.h"
#include "bodies/common/admit.h"
