// list_samples: the samples of the round, in the order of their draws.
#include "bodies/common/dialect.h"
KERNEL(list_samples, serve_list_samples, SampleArguments, LIST_SAMPLES_BINDINGS)
#include "bodies/common/write_sample.h"
#include "bodies/common/list_samples.h"
