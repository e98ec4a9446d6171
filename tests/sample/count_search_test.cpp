// The search for the size of a count ends with a set that has exactly the count, or a few more.
#include <gtest/gtest.h>

#include "sampling/count_search.h"

namespace lacuna {
namespace {

TEST(TheSearchForACount, TakesASetOfExactlyTheCountAndNoneThatIsFarLarger) {
    const Mask everywhere{2, 1, {1, 1}};
    Request request;
    request.count = 500;
    for (const Mask* const mask : {static_cast<const Mask*>(nullptr), &everywhere}) {
        request.places.mask = mask;
        const auto search = search_for_count(request, nullptr);
        const Trial first = search->next();
        EXPECT_FALSE(search->is_enough(499));
        EXPECT_LT(search->next().request->radius, first.request->radius);
        EXPECT_TRUE(search->is_enough(500));
        // The points of one radius are cut at the count; with a mask a large set is no answer.
        if (mask == nullptr) continue;
        EXPECT_FALSE(search->is_enough(1000));
        EXPECT_GT(search->next().request->radius, first.request->radius);
    }
}

}  // namespace
}  // namespace lacuna
