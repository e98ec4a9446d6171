// admit in lines and exact: no earlier sample of the round may be closer than the radius.
#include "bodies/common/dialect.h"
KERNEL(admit, serve_admit, DrawArguments, ADMIT_BINDINGS)
#include "bodies/lines/decide.h"
#include "bodies/common/admit.h"
