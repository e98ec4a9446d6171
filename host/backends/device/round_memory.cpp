// What every mode keeps on the device of a round, and what moves between it and the host.
#include "backends/device/round_memory.h"

#include <algorithm>
#include <bit>
#include <string>

#include "backends/columns.h"
#include "backends/device/layout.h"
#include "portable/failure.h"

namespace lacuna::device {
namespace {

constexpr std::uint64_t kSortWork = 4;  // a draw; see Queue::launch
// Buffers are no smaller: small sets then never make them anew.
constexpr std::uint64_t kLeastWords = 4096;

constexpr std::array kJobs{"locate", "sort_columns", "admit", "gather", "subtract", "refine"};
static_assert(FAILED_LOCATE == 1 && FAILED_SORT_COLUMNS == 2 && FAILED_ADMIT == 4 &&
              FAILED_GATHER == 8 && FAILED_SUBTRACT == 16 && FAILED_REFINE == 32 &&
              FAILED_CHORDS == 64);

}  // namespace

RoundMemory::RoundMemory(const Plan& the_plan, Queue& the_queue)
    : plan(the_plan), queue(the_queue), geometry(geometry_of(plan, count_columns(plan), 0)) {
    make_room(memory.column_begins, geometry.columns + std::uint64_t{1});
    make_room(memory.undecided, kPasses);
    make_room(memory.failure, 1);
}

void RoundMemory::make_room(Buffer& buffer, std::uint64_t words) const {
    if (buffer.words() >= words && buffer.words() != 0) return;
    buffer = {};  // first let go of what was there
    buffer = queue.make(std::max(words, kLeastWords) * kWord);
}

Buffer RoundMemory::copy_of(std::span<const std::uint32_t> words) {
    Buffer copy;
    make_room(copy, words.size());
    put(copy, words);
    return copy;
}

// Expects column_begins.
void RoundMemory::begin(std::uint32_t count) {
    draw_count = count;
    by_order.resize(count);
    const std::uint64_t words = count;
    for (Buffer* const one : {&memory.buckets, &memory.fates}) make_room(*one, words);
    make_room(memory.samples, 2 * words);
    for (Buffer* const four : {&memory.draws, &memory.located, &memory.candidates})
        make_room(*four, 4 * words);
    put<std::uint32_t>(memory.column_begins, column_begins);
    queue.fill(memory.undecided, 0, kPasses);
    queue.fill(memory.failure, 0, 1);
}

void RoundMemory::upload(std::span<const Draw> draws, std::span<const std::uint32_t> place_begins) {
    find_column_begins(place_begins, draws, column_begins);
    begin(static_cast<std::uint32_t>(draws.size()));
    put(memory.draws, draws);
}

void RoundMemory::sort() {
    launch<kernels::sort_columns>(queue, memory, {0, kPasses - 1, geometry, 0}, geometry.columns,
                                  kSortWork * draws_per_column());
}

void RoundMemory::begin_more_passes() {
    queue.fill(memory.undecided, 0, kPasses);
    queue.fill(memory.undecided, 1, 1);
}

void RoundMemory::start_download() {
    get<Sample>(memory.samples, by_order);
    get<std::uint32_t>(memory.undecided, undecided_);
    get<std::uint32_t>(memory.failure, failure_);
}

void RoundMemory::throw_if_failed() const {
    const std::uint32_t failed = failure_.front();
    if (failed == 0) return;
    if ((failed & FAILED_CHORDS) != 0)
        throw DeviceError("device " + queue.device().name +
                          ": refine: more chords near a box than there is room for");
    throw ended_early(queue.device(), kJobs.at(static_cast<std::size_t>(std::countr_zero(failed))));
}

portable::DrawArguments RoundMemory::arguments(std::uint32_t pass) const {
    return {0, queue.chunk_of(draw_count), geometry, draw_count, pass, 0, 0, 0, 0, 0};
}

void RoundMemory::snapshot(Snapshot& snapshot) {
    snapshot.capacity = geometry.capacity;
    snapshot.candidates.resize(draw_count);
    snapshot.fates.resize(draw_count);
    get<Candidate>(memory.candidates, snapshot.candidates);
    get<std::uint32_t>(memory.fates, snapshot.fates);
    queue.wait();
}

void RoundMemory::restore_candidates(const Snapshot& snapshot) {
    find_column_begins(plan, geometry.columns, snapshot.candidates, column_begins);
    begin(static_cast<std::uint32_t>(snapshot.candidates.size()));
    put<Candidate>(memory.located, snapshot.candidates);
    queue.wait();
}

void RoundMemory::restore_fates(const Snapshot& snapshot) {
    put<std::uint32_t>(memory.fates, snapshot.fates);
    const std::vector<Sample> samples = samples_by_order(snapshot);
    put<Sample>(memory.samples, samples);
    queue.wait();
}

}  // namespace lacuna::device
