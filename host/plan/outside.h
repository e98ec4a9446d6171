// Plans with kept points that lie outside of the request's domain.
#pragma once

#include <lacuna/lacuna.h>

#include <list>

#include "base/polling.h"

namespace lacuna {

// A request for its plan: the domain reaches as far around that of the user's request as the kept
// points outside need, and each mask is in the middle of this domain.
struct Around {
    Request request;
    std::list<Mask> masks;  // what the request's masks point to, if the domain is larger
};

// The points to keep of the request are sorted (plan/kept.h).
Around around_kept(const Request& request, const Poll& poll);

}  // namespace lacuna
