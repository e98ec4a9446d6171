// measure: the least radius under each new box.
#include "bodies/common/dialect.h"
KERNEL(measure, serve_measure, StripArguments, MEASURE_BINDINGS)
#include "bodies/exact/radius_field.h"
#include "bodies/exact/measure.h"
