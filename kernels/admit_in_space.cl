// admit in space: no earlier sample of the round may be closer than the radius.
#include "bodies/common/dialect.h"
KERNEL(admit_in_space, serve_admit, DrawArguments, ADMIT_IN_SPACE_BINDINGS)
#include "bodies/space/decide_in_space.h"
#include "bodies/common/admit.h"
