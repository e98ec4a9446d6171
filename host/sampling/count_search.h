// How a count becomes a radius or, with a field, a scale.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <memory>

#include "plan/checked_request.h"
#include "plan/make_plan.h"

namespace lacuna {

// A request with a radius or a scale instead of a count, and with a limit of samples.
struct Trial {
    CheckedRequest request;
    bool is_pilot = false;  // its set only shows how many samples a scale gives
};

// Proposes sizes at which a maximal set has somewhat more samples than request.count, until one
// has: the first request.count of its samples are the answer. Call next() and is_enough() in turns.
class CountSearch {
public:
    virtual ~CountSearch() = default;
    // Throws BadRequest if the size would be smaller than the grid allows, and MemoryRefused.
    virtual Trial next() = 0;
    // Whether the set of the last trial, with this number of points, is the answer.
    virtual bool is_enough(std::uint64_t points) = 0;
};

// `sums` are the field's sums in mode cells, and null in other modes. They must outlive the search.
std::unique_ptr<CountSearch> search_for_count(const CheckedRequest& request, const FieldSums* sums,
                                              const Poll& poll = nobody_asks);

}  // namespace lacuna
