// scan: prefix sums of counts, which tell where what was counted goes.
#include "bodies/common/prelude.h"

BINDINGS(ScanArguments, SCAN_BINDINGS)
#include "bodies/common/scan.h"
ENTRY(scan, serve_scan, ScanArguments, SCAN_BINDINGS)
