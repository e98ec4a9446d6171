// list_samples: the samples of the round, in the order of their draws.
#include "bodies/common/prelude.h"
KERNEL(list_samples, serve_list_samples, SampleArguments, LIST_SAMPLES_BINDINGS)
#include "bodies/common/list_samples.h"
