// scan: prefix sums of counts, which tell where what was counted goes.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bodies/common/prelude.h"

#ifdef ENTRY_scan
BINDINGS(ScanArguments, SCAN_BINDINGS)
#include "bodies/common/scan.h"
ENTRY(scan, serve_scan, ScanArguments, SCAN_BINDINGS)
#endif
