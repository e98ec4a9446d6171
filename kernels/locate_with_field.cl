// locate with a radius field: a draw becomes a candidate with the radius at its position.
#include "bodies/common/dialect.h"
KERNEL(locate_with_field, serve_locate_with_field, DrawArguments, LOCATE_WITH_FIELD_BINDINGS)
#include "bodies/exact/radius_field.h"
#include "bodies/exact/locate_with_field.h"
