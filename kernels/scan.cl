// scan: prefix sums of counts, which tell where what was counted goes.
#include "bodies/common/prelude.h"
KERNEL(scan, serve_scan, ScanArguments, SCAN_BINDINGS)
#include "bodies/common/scan.h"
