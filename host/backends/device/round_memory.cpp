// A round's memory on the device in every mode, and the transfers between it and the host.
#include "backends/device/round_memory.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <string>
#include <tuple>

#include "backends/columns.h"
#include "backends/device/layout.h"
#include "backends/device/scan.h"
#include "portable/column.h"
#include "portable/failure.h"
#include "portable/status.h"

namespace lacuna::device {
namespace {

constexpr std::uint64_t kSortWork = 4;  // of a draw; see Queue::launch
// The smallest buffer: small sets then never replace their buffers.
constexpr std::uint64_t kLeastWords = 4096;

constexpr std::array kJobs{"locate", "sort_columns", "admit", "collect", "subtract", "refine"};
static_assert(FAILED_LOCATE == 1 && FAILED_SORT_COLUMNS == 2 && FAILED_ADMIT == 4 &&
              FAILED_COLLECT == 8 && FAILED_SUBTRACT == 16 && FAILED_REFINE == 32 &&
              FAILED_CHORDS == 64);

}  // namespace

RoundMemory::RoundMemory(const Plan& the_plan, Queue& the_queue)
    : plan(the_plan), queue(the_queue), geometry(geometry_of(plan, count_columns(plan), 0)) {
    make_room(memory.column_begins, geometry.columns + std::uint64_t{1});
    make_room(memory.report, REPORT_WORDS);
    queue.fill(memory.report, 0, REPORT_WORDS);
}

void RoundMemory::make_room(Buffer& buffer, std::uint64_t words) const {
    if (buffer.words() >= words && buffer.words() != 0) return;
    const std::uint64_t bytes = std::max(words, kLeastWords) * kWord;
    const DeviceEntry& device = queue.device();
    refuse_if_too_large(device.name, Needs{0, bytes}, device.memory_bytes,
                        device.largest_buffer_bytes);
    buffer = {};  // frees the old memory first
    buffer = queue.make(bytes);
}

void RoundMemory::grow(Buffer& buffer, std::uint64_t kept_words, std::uint64_t words) {
    if (words <= buffer.words()) return;
    std::vector<std::uint32_t> kept(kept_words);
    get<std::uint32_t>(buffer, kept);
    queue.wait();
    const std::uint64_t most = queue.device().largest_buffer_bytes / (4 * kWord) * 4;
    make_room(buffer, std::max(words, std::min(words + words / 2, most)));
    put<std::uint32_t>(buffer, kept);
    queue.wait();
}

Buffer RoundMemory::copy_of(std::span<const std::uint32_t> words) {
    Buffer copy;
    make_room(copy, words.size());
    put(copy, words);
    return copy;
}

void RoundMemory::begin(std::uint32_t count) {
    draw_count = count;
    part = {0, count};
    const std::uint64_t words = count;
    make_room(memory.statuses, words);
    make_room(memory.outcomes, 2 * std::uint64_t{portable::words_of_column(count)});
    for (Buffer* const four : {&memory.draws, &memory.candidates}) make_room(*four, 4 * words);
    if (sorts()) make_room(memory.buckets, words);
    if (sorts()) make_room(memory.located, 4 * words);
    queue.fill(memory.outcomes, 0, 2 * std::uint64_t{portable::words_of_column(count)});
    queue.fill(memory.report, 0, REPORT_WORDS);
    report = {};
}

void RoundMemory::upload(std::span<const Draw> draws, std::span<const std::uint32_t> sorted_columns,
                         PartLimits limits) {
    if (sorted_columns.empty())
        column_begins_ = {0, static_cast<std::uint32_t>(draws.size())};
    else
        find_column_begins(sorted_columns, draws, column_begins_);
    arrangement_ = arrange(draws, column_begins_, limits);
    begin(static_cast<std::uint32_t>(draws.size()));
    arranged_.clear();
    for (const std::uint32_t origin : arrangement_.origins) arranged_.push_back(draws[origin]);
    draws_ = parts() == 1 ? draws : arranged_;
    put(memory.draws, draws_);
}

void RoundMemory::open_part(std::uint32_t number) {
    part = {number == 0 ? 0 : arrangement_.ends[number - 1], arrangement_.ends[number]};
    if (sorts() && parts() > 1) {
        column_begins_.assign(geometry.columns + std::size_t{1}, 0);
        for (std::uint32_t i = part.begin; i < part.end; ++i)
            ++column_begins_[arrangement_.columns[i] + 1];
        column_begins_[0] = part.begin;
        std::partial_sum(column_begins_.begin(), column_begins_.end(), column_begins_.begin());
    }
    if (sorts()) put<std::uint32_t>(memory.column_begins, column_begins_);
    if (number > 0) queue.fill(memory.report, 0, kPasses);
    has_more_passes_ = false;
}

void RoundMemory::sort() {
    launch<kernels::sort_columns>(queue, memory, {.last_pass = kPasses - 1, .g = geometry},
                                  geometry.columns, kSortWork * draws_per_column());
}

void RoundMemory::begin_more_passes() {
    queue.fill(memory.report, 0, kPasses);
    has_more_passes_ = true;
}

void RoundMemory::find_done(std::uint32_t first, std::vector<bool>& is_done) {
    std::vector<std::uint32_t> statuses(draw_count);
    get<std::uint32_t>(memory.statuses, statuses);
    queue.wait();
    for (std::uint32_t number = first; number < parts(); ++number) {
        const std::uint32_t begin = number == 0 ? 0 : arrangement_.ends[number - 1];
        const auto of_part = std::span(statuses).subspan(begin, arrangement_.ends[number] - begin);
        is_done[number] =
            std::find(of_part.begin(), of_part.end(), STATUS_UNDECIDED) == of_part.end();
    }
}

void RoundMemory::start_download() {
    get<std::uint32_t>(memory.report, report);
}

void RoundMemory::reset(std::uint32_t word) {
    if (report[word] == 0) return;
    std::fill_n(report.begin(), kPasses, 0u);
    report[word] = 0;
    put<std::uint32_t>(memory.report, report);
}

void RoundMemory::make_room_for_listing(Listing listing) {
    make_room_to_scan(*this,
                      std::uint64_t{listing.counts_before} + portable::words_of_column(draw_count));
    const std::uint64_t bins = listing.bins == 0 ? listing.room : listing.bins;
    make_room(memory.results,
              listing.words_of_bin * bins + words_of_sample() * std::uint64_t{draw_count});
}

portable::SampleArguments RoundMemory::arguments_of(Listing listing, std::uint32_t amount) const {
    return {.chunk = queue.chunk_of(amount),
            .draws = draw_count,
            .last_pass = kPasses - 1,
            .counts_before = listing.counts_before,
            .block_bits =
                block_bits_of_scan(listing.counts_before + portable::words_of_column(draw_count)),
            .words_of_bin = listing.words_of_bin,
            .bins = listing.bins,
            .room = listing.room};
}

void RoundMemory::count_samples(Listing listing) {
    const std::uint32_t words = portable::words_of_column(draw_count);
    const portable::SampleArguments arguments = arguments_of(listing, words);
    launch<kernels::count_samples>(queue, memory, arguments, items_of(words, arguments.chunk),
                                   arguments.chunk);
    scan(queue, memory, listing.counts_before + words);
}

std::span<const std::uint32_t> RoundMemory::download_results(std::size_t words_of_bins) {
    const std::size_t words = words_of_bins + words_of_sample() * std::size_t{report[SAMPLES_WORD]};
    HostMemory& results = words_of_bins == 0 ? samples_alone_ : results_;
    if (results.bytes() < words * kWord) {
        results = {};  // frees the old memory first
        results = queue.host_memory(memory.results.bytes());
    }
    const std::span<std::uint32_t> all = results.values<std::uint32_t>(words);
    get(memory.results, all);
    samples_in_ = &results;
    samples_begin_ = words_of_bins * kWord;
    return all.first(words_of_bins);
}

void RoundMemory::find_orders(std::vector<std::uint32_t>& orders) {
    std::vector<std::uint32_t> words(portable::words_of_column(draw_count));
    get<std::uint32_t>(memory.outcomes, words);
    queue.wait();
    orders.clear();
    for (std::uint32_t order = 0; order < draw_count; ++order)
        if ((words[order / 32] >> order % 32 & 1) != 0) orders.push_back(order);
}

void RoundMemory::throw_if_failed() const {
    const std::uint32_t failed = report[FAILURE_WORD];
    if (failed == 0) return;
    if ((failed & FAILED_CHORDS) != 0)
        throw DeviceError("device " + queue.device().name +
                          ": refine: more chords near a box than there is room for");
    throw ended_early(queue.device(), kJobs.at(static_cast<std::size_t>(std::countr_zero(failed))));
}

portable::DrawArguments RoundMemory::arguments() const {
    return {.chunk = queue.chunk_of(part_count()),
            .g = geometry,
            .first = part.begin,
            .count = part.end,
            .last_pass = kPasses - 1};
}

std::vector<Candidate> RoundMemory::candidates() {
    std::vector<Candidate> all(draw_count);
    get<Candidate>(memory.candidates, all);
    queue.wait();
    return all;
}

void RoundMemory::snapshot(Snapshot& snapshot) {
    snapshot.capacity = geometry.capacity;
    snapshot.candidates = candidates();
    snapshot.statuses.resize(draw_count);
    get<std::uint32_t>(memory.statuses, snapshot.statuses);
    queue.wait();
    if (parts() > 1 || !sorts()) merge_parts(snapshot);
}

void RoundMemory::merge_parts(Snapshot& snapshot) const {
    const Snapshot by_part = snapshot;
    std::vector<std::uint32_t> all(draw_count);
    std::iota(all.begin(), all.end(), 0);
    const auto key = [&](std::uint32_t i) {
        const Candidate& candidate = by_part.candidates[i];
        if (plan.has_radius_field()) return std::tuple(0u, 0u, candidate.order);
        return std::tuple(portable::column_of_line(candidate.home, plan.lines, geometry.columns),
                          candidate.y, candidate.order);
    };
    std::sort(all.begin(), all.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    for (std::uint32_t i = 0; i < draw_count; ++i) {
        snapshot.candidates[i] = by_part.candidates[all[i]];
        snapshot.statuses[i] = by_part.statuses[all[i]];
        if (plan.has_radius_field()) snapshot.candidates[i].home = 0;
    }
}

std::vector<Candidate> RoundMemory::restored_candidates(const Snapshot& snapshot,
                                                        PartLimits limits) {
    const auto count = static_cast<std::uint32_t>(snapshot.candidates.size());
    column_begins_ = {0, count};
    if (sorts()) find_column_begins(plan, geometry.columns, snapshot.candidates, column_begins_);
    arrangement_ = arrange(std::span(snapshot.candidates), column_begins_, limits);
    begin(count);
    std::vector<Candidate> candidates = snapshot.candidates;
    for (std::size_t i = 0; i < arrangement_.origins.size(); ++i)
        candidates[i] = snapshot.candidates[arrangement_.origins[i]];
    return candidates;
}

void RoundMemory::restore_statuses(const Snapshot& snapshot) {
    std::vector<std::uint32_t> statuses = snapshot.statuses;
    for (std::size_t i = 0; i < arrangement_.origins.size(); ++i)
        statuses[i] = snapshot.statuses[arrangement_.origins[i]];
    put<std::uint32_t>(memory.statuses, statuses);
    const std::vector<std::uint32_t> outcomes = outcomes_of(snapshot);
    put<std::uint32_t>(memory.outcomes, outcomes);
    queue.wait();
}

}  // namespace lacuna::device
