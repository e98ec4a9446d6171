// scan: turns counts into prefix sums, the indices at which kernels write.
#include "bodies/common/dialect.h"
KERNEL(scan, serve_scan, ScanArguments, SCAN_BINDINGS)
#include "bodies/common/scan.h"
