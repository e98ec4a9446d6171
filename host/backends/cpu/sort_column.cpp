// The order of a column's candidates, found by way of buckets (portable/column.h).
#include "backends/cpu/sort_column.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "portable/column.h"

namespace lacuna::cpu {
namespace {

bool comes_before(const Candidate& a, const Candidate& b) {
    return a.y < b.y || (a.y == b.y && a.order < b.order);
}

}  // namespace

// Most of the work is to find the bucket.
void sort_column(std::span<Candidate> candidates, std::uint32_t height) {
    thread_local std::vector<std::uint32_t> buckets;
    thread_local std::vector<Candidate> located;
    const auto count = static_cast<std::uint32_t>(candidates.size());
    const auto bucket_of = [&](const Candidate& candidate) {
        return portable::bucket_of(candidate.y, count, height);
    };

    // Count the draws of each bucket, and find where each begins.
    buckets.assign(count, 0);
    for (const Candidate& candidate : candidates) ++buckets[bucket_of(candidate)];
    std::exclusive_scan(buckets.begin(), buckets.end(), buckets.begin(), 0u);

    // Share the draws out.
    located.assign(candidates.begin(), candidates.end());
    for (const Candidate& candidate : located)
        candidates[buckets[bucket_of(candidate)]++] = candidate;

    // Order those of one bucket, which ends where the next one begins.
    std::uint32_t begin = 0;
    for (const std::uint32_t end : buckets) {
        if (end - begin > 1)
            std::sort(candidates.begin() + begin, candidates.begin() + end, comes_before);
        begin = end;
    }
}

}  // namespace lacuna::cpu
