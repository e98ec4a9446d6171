// Sorts a column's candidates by y into buckets, with which it also finds candidates by y.
#include <algorithm>
#include <numeric>
#include <vector>

#include "backends/cpu/state.h"
#include "portable/column.h"

namespace lacuna::cpu {

void State::sort_column(std::uint32_t column) {
    thread_local std::vector<Candidate> of_thread;
    std::vector<Candidate>& located = of_thread;  // looked up once, see subtract.cpp
    const std::uint32_t count = column_begins[column + 1] - column_begins[column];
    const auto own = std::span(candidates).subspan(column_begins[column], count);
    const auto begins = std::span(buckets).subspan(column_begins[column], count);
    const auto bucket_of = [&](const Candidate& candidate) {
        return portable::bucket_of(candidate.y, count, plan.height);
    };

    // Count the candidates of each bucket, and find where each ends.
    std::fill(begins.begin(), begins.end(), 0);
    for (const Candidate& candidate : own) ++begins[bucket_of(candidate)];
    std::inclusive_scan(begins.begin(), begins.end(), begins.begin());

    // Move the candidates to their buckets, which fill from the end down to the begin.
    located.assign(own.begin(), own.end());
    for (const Candidate& candidate : located) own[--begins[bucket_of(candidate)]] = candidate;

    // Sort each bucket, which ends where the next one begins.
    std::uint32_t end = count;
    for (std::uint32_t bucket = count; bucket-- > 0;) {
        const std::uint32_t begin = begins[bucket];
        if (end - begin > 1) std::sort(own.begin() + begin, own.begin() + end, comes_before);
        end = begin;
    }
}

std::uint32_t State::first_from(std::uint32_t column, std::uint32_t y) const {
    const std::uint32_t begin = column_begins[column];
    const std::uint32_t end = column_begins[column + 1];
    if (begin == end) return end;
    std::uint32_t i = begin + buckets[begin + portable::bucket_of(y, end - begin, plan.height)];
    while (i < end && candidates[i].y < y) ++i;
    return i;
}

std::uint32_t State::count_between(std::uint32_t column, std::uint32_t low,
                                   std::uint32_t high) const {
    const std::uint32_t begin = column_begins[column];
    const std::uint32_t count = column_begins[column + 1] - begin;
    if (count == 0 || low >= high) return 0;
    const std::uint32_t next = portable::bucket_of(high - 1, count, plan.height) + 1;
    const std::uint32_t end = next < count ? buckets[begin + next] : count;
    return end - buckets[begin + portable::bucket_of(low, count, plan.height)];
}

}  // namespace lacuna::cpu
