// See tbb/one_thread.h.
#pragma once

#include <tbb/one_thread.h>  // IWYU pragma: export
