// locate: the rank of each draw, walked to a y through its place's free length.
#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include "cpu/state.h"
#include "portable/column.h"
#include "portable/fate.h"

namespace lacuna::cpu {
namespace {

bool comes_before(const Candidate& a, const Candidate& b) {
    return a.y < b.y || (a.y == b.y && a.order < b.order);
}

// Draws [begin, end) of lines. A line is walked once for all its draws, which ascend in rank.
void locate_on_lines(State& state, std::span<const Draw> draws, std::uint32_t begin,
                     std::uint32_t end) {
    const Span* span = nullptr;
    std::uint32_t passed = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
        const std::uint32_t line = draws[i].place;
        if (i == begin || line != draws[i - 1].place) {
            span = state.slot(line).data();
            passed = 0;
        }
        while (draws[i].rank - passed >= span->end - span->begin) {
            passed += span->end - span->begin;
            ++span;
        }
        state.candidates[i] = {line * state.plan.strip_width + draws[i].offset,
                               span->begin + (draws[i].rank - passed), line, draws[i].order};
    }
}

void locate_in_boxes(State& state, std::span<const Draw> draws, std::uint32_t column) {
    for (std::uint32_t i = state.column_begins[column]; i < state.column_begins[column + 1]; ++i) {
        const Box& box = state.boxes[column][draws[i].place - state.place_begins[column]];
        state.candidates[i] = {box.x + draws[i].offset, box.begin + draws[i].rank,
                               box.x / state.plan.strip_width, draws[i].order};
    }
}

// By y, and by order where y is equal. Most of the work is to find the bucket.
void sort(std::span<Candidate> candidates, std::uint32_t height) {
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

}  // namespace

void locate(State& state, std::span<const Draw> draws, std::uint32_t column) {
    const std::uint32_t begin = state.column_begins[column];
    const std::uint32_t end = state.column_begins[column + 1];
    if (state.has_boxes())
        locate_in_boxes(state, draws, column);
    else
        locate_on_lines(state, draws, begin, end);
    sort(std::span(state.candidates).subspan(begin, end - begin), state.plan.height);
    std::fill(state.fates.begin() + begin, state.fates.begin() + end, FATE_UNDECIDED);
}

}  // namespace lacuna::cpu
