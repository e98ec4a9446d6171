// What a request promises of its set before it is made.
#pragma once

#include <lacuna/verify.h>

namespace lacuna::options {

// The sizes that were asked for, 0 where there is none, and where points may lie, their classes and
// kept points. The field, mask and kept points of the request must outlive the claim.
Claim claim_of(const Request& request);

}  // namespace lacuna::options
