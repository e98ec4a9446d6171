// Sorts a column's candidates by y into buckets, with which it also finds candidates by y.
#include "backends/cpu/sorted_bins.h"

#include <algorithm>
#include <numeric>

#include "plan/first_free.h"
#include "portable/column.h"

namespace lacuna::cpu {

SortedBins::SortedBins(const Plan& plan, Workers& workers)
    : Bins(plan, workers, count_columns(plan)) {
    begins = first_lines(plan, round.columns);
    free_lengths = first_free_lengths(plan);
}

void SortedBins::make_room(std::size_t count) {
    round.make_room(count);
    buckets_.resize(count);
}

void SortedBins::set_undecided(std::uint32_t column) {
    sort_column(column);
    round.set_undecided(column);
}

// Snapshots have the candidates in the order that sort_column gives them.
void SortedBins::restore(const Snapshot& snapshot) {
    round.restore(snapshot, [&](const Candidate& candidate) {
        return portable::column_of_line(candidate.home, round.plan.lines, round.columns);
    });
    make_room(round.candidates.size());
    for (std::uint32_t column = 0; column < round.columns; ++column) sort_column(column);
}

void SortedBins::sort_column(std::uint32_t column) {
    thread_local std::vector<Candidate> of_thread;
    std::vector<Candidate>& located = of_thread;  // looked up once, see subtract.cpp
    const std::uint32_t first = round.column_begins[column];
    const std::uint32_t count = round.column_begins[column + 1] - first;
    const auto own = std::span(round.candidates).subspan(first, count);
    const auto begins_of_buckets = std::span(buckets_).subspan(first, count);
    const auto bucket_of = [&](const Candidate& candidate) {
        return portable::bucket_of(candidate.y, count, round.plan.height);
    };

    // Count the candidates of each bucket, and find where each ends.
    std::fill(begins_of_buckets.begin(), begins_of_buckets.end(), 0);
    for (const Candidate& candidate : own) ++begins_of_buckets[bucket_of(candidate)];
    std::inclusive_scan(begins_of_buckets.begin(), begins_of_buckets.end(),
                        begins_of_buckets.begin());

    // Move the candidates to their buckets, which fill from the end down to the begin.
    located.assign(own.begin(), own.end());
    for (const Candidate& candidate : located)
        own[--begins_of_buckets[bucket_of(candidate)]] = candidate;

    // Sort each bucket, which ends where the next one begins.
    std::uint32_t end = count;
    for (std::uint32_t bucket = count; bucket-- > 0;) {
        const std::uint32_t begin = begins_of_buckets[bucket];
        if (end - begin > 1) std::sort(own.begin() + begin, own.begin() + end, comes_before);
        end = begin;
    }
}

std::uint32_t SortedBins::first_from(std::uint32_t column, std::uint32_t y) const {
    const std::uint32_t begin = round.column_begins[column];
    const std::uint32_t end = round.column_begins[column + 1];
    if (begin == end) return end;
    std::uint32_t i =
        begin + buckets_[begin + portable::bucket_of(y, end - begin, round.plan.height)];
    while (i < end && round.candidates[i].y < y) ++i;
    return i;
}

std::uint32_t SortedBins::count_between(std::uint32_t column, std::uint32_t low,
                                        std::uint32_t high) const {
    const std::uint32_t begin = round.column_begins[column];
    const std::uint32_t count = round.column_begins[column + 1] - begin;
    if (count == 0 || low >= high) return 0;
    const std::uint32_t height = round.plan.height;
    const std::uint32_t next = portable::bucket_of(high - 1, count, height) + 1;
    const std::uint32_t end = next < count ? buckets_[begin + next] : count;
    return end - buckets_[begin + portable::bucket_of(low, count, height)];
}

}  // namespace lacuna::cpu
