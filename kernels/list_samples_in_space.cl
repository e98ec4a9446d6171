// list_samples in space: each sample has three words.
#include "bodies/common/dialect.h"
KERNEL(list_samples_in_space, serve_list_samples, SampleArguments, LIST_SAMPLES_IN_SPACE_BINDINGS)
#include "bodies/space/write_in_space.h"
#include "bodies/common/list_samples.h"
