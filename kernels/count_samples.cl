// count_samples: how many samples the round has, by the orders of their draws.
#include "bodies/common/dialect.h"
KERNEL(count_samples, serve_count_samples, SampleArguments, COUNT_SAMPLES_BINDINGS)
#include "bodies/common/count_samples.h"
