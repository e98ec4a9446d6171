// A round's memory on the device in every mode: its draws, their candidates and statuses, and flags
// that say whether the work was finished.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "backends/device/kernels.h"
#include "backends/device/layout.h"
#include "backends/device/parts.h"
#include "backends/device/queue.h"
#include "plan/plan.h"
#include "portable/bits.h"
#include "portable/report.h"

namespace lacuna::device {

// The number of passes of admit queued at a time. A pass that finds nothing undecided returns at
// once.
inline constexpr std::uint32_t kPasses = PASSES;

// These vectors must not change until queue.wait() returns: transfers use them.
struct RoundMemory {
    RoundMemory(const Plan& plan, Queue& queue);

    // Queues the upload of the draws, part by part, and makes room for their candidates.
    // sorted_columns: see Bins.
    void upload(std::span<const Draw> draws, std::span<const std::uint32_t> sorted_columns,
                PartLimits limits);
    std::uint32_t parts() const { return static_cast<std::uint32_t>(arrangement_.ends.size()); }
    // All later commands serve this part. If candidates are sorted column by column, queues the
    // upload of column_begins; if there are also several parts, call queue.wait() first.
    void open_part(std::uint32_t number);
    // Waits, then sets is_done for the parts from `first` on: whether all their draws are decided.
    void find_done(std::uint32_t first, std::vector<bool>& is_done);
    std::span<const Draw> draws_of_part() const {
        return draws_.subspan(part.begin, part.end - part.begin);
    }
    // Sorts the part's located candidates by column and y.
    void sort();
    // Call it before more passes than the first kPasses are queued. From then on an item of admit
    // serves one candidate. If draws crowd, an item of several leaves some to the next pass
    // (bodies/common/admit.h), and others might wait forever for one that is left in every pass.
    void begin_more_passes();

    // Queues the download of report[]. After the wait, is_unsettled says if a draw is undecided,
    // and throw_if_failed throws DeviceError if a kernel could not finish.
    void start_download();
    // Sets a word of report[] to 0, here and on the device, and the words of passes too, which must
    // not be under way. Queues nothing if it is 0.
    void reset(std::uint32_t word);
    bool is_unsettled() const { return report[kPasses - 1] != 0; }
    void throw_if_failed() const;

    // How results[] lists what a round made: words_of_bin words for each bin, then the samples.
    struct Listing {
        std::uint32_t counts_before = 0;  // numbers of boxes in counts[], before the samples'
        std::uint32_t words_of_bin = 0;
        std::uint32_t bins = 0;                  // 0: the bins are the new boxes, by their count
        std::uint32_t room = ~std::uint32_t{0};  // with more new boxes nothing is listed
    };
    // Makes room in counts[] and results[] for what these commands write.
    void make_room_for_listing(Listing listing);
    void count_samples(Listing listing);
    template <typename Kernel = kernels::list_samples>
    void list_samples(Listing listing) {
        const portable::SampleArguments arguments = arguments_of(listing, draw_count);
        launch<Kernel>(queue, memory, arguments, items_of(draw_count, arguments.chunk),
                       arguments.chunk);
    }
    // The number of new boxes that were counted.
    std::uint32_t new_boxes() const { return report[TOTAL_WORD] - report[SAMPLES_WORD]; }
    // Queues the download of the first words_of_bins words of results[], which it returns, and of
    // the samples after them. The wait fills in both. They are valid until the next call.
    std::span<const std::uint32_t> download_results(std::size_t words_of_bins);
    // The samples, as many words each as words_of_sample.
    template <typename Words>
    std::span<const Words> samples() const {
        if (samples_in_ == nullptr) return {};
        return samples_in_->values<const Words>(report[SAMPLES_WORD], samples_begin_);
    }
    std::uint32_t words_of_sample() const { return plan.is_space() ? 3 : 2; }
    // Lists the orders of the samples' draws. Waits.
    void find_orders(std::vector<std::uint32_t>& orders);
    // The number of draws that no sample of an earlier round covers.
    std::uint64_t survivors() const { return draw_count - report[COVERED_WORD]; }

    // Arguments of the kernels over the part's draws, and their launch.
    portable::DrawArguments arguments() const;
    template <typename Kernel>
    void launch_over_draws(portable::DrawArguments arguments, std::uint64_t work_of_draw) {
        launch<Kernel>(queue, memory, arguments,
                       items_of(arguments.count - arguments.first, arguments.chunk),
                       work_of_draw * arguments.chunk);
    }
    // Queues a pass of admit. Pass 0 looks at all draws, later passes at few.
    template <typename Kernel>
    void admit(portable::DrawArguments arguments, std::uint32_t pass, std::uint32_t chunk) {
        arguments.pass = pass;
        arguments.chunk = has_more_passes_ ? 1 : chunk;
        launch_over_draws<Kernel>(arguments, pass == 0 ? 6 : 1);
    }
    // Queues a screen of these draws: see Bins::screen.
    template <typename Kernel>
    void screen(Range draws, std::uint32_t status, std::uint64_t work_of_draw,
                bool is_listed = false) {
        portable::DrawArguments screening = arguments();
        screening.first = draws.begin;
        screening.count = draws.end;
        screening.status = status;
        screening.is_listed = is_listed ? 1 : 0;
        launch_over_draws<Kernel>(screening, work_of_draw);
    }
    // The number of draws of the part; and of one of its columns on average, rounded up.
    std::uint32_t part_count() const { return part.end - part.begin; }
    std::uint32_t draws_per_column() const { return part_count() / geometry.columns + 1; }

    // Queues the upload and the download of a table.
    template <typename T>
    void put(const Buffer& to, std::span<const T> from, std::uint64_t first_word = 0) {
        queue.upload(to, std::as_bytes(from), first_word * kWord);
    }
    template <typename T>
    void get(const Buffer& from, std::span<T> to) {
        queue.download(from, std::as_writable_bytes(to));
    }
    // Makes room for at least `words` words. The old content is lost if there was less room.
    void make_room(Buffer& buffer, std::uint64_t words) const;
    // Makes room for at least `words` words of four-word elements, and keeps the first
    // `kept_words`. If there was less room, it becomes half as large again, if the device allows
    // it. Waits then.
    void grow(Buffer& buffer, std::uint64_t kept_words, std::uint64_t words);
    // Makes room, and uploads `from`, then zeros up to the buffer's end: Oclgrind regards what
    // kernels write past the last upload as uninitialized. Waits.
    template <typename T>
    void put_in_room(Buffer& buffer, std::span<const T> from) {
        make_room(buffer, from.size_bytes() / kWord);
        const std::vector<std::byte> rest(buffer.bytes() - from.size_bytes());
        put(buffer, from);
        queue.upload(buffer, rest, from.size_bytes());
        queue.wait();
    }
    Buffer copy_of(std::span<const std::uint32_t> words);

    // The sorted candidates. Waits.
    std::vector<Candidate> candidates();

    void snapshot(Snapshot& snapshot);
    // Begins a round with the candidates, part by part; once they are sorted, sets their statuses.
    std::vector<Candidate> restored_candidates(const Snapshot& snapshot, PartLimits limits);
    void restore_statuses(const Snapshot& snapshot);

    const Plan& plan;
    Queue& queue;
    Memory memory;
    portable::Geometry geometry;
    std::uint32_t draw_count = 0;                      // of the round
    Range part{0, 0};                                  // of the draws
    std::array<std::uint32_t, REPORT_WORDS> report{};  // as downloaded

private:
    bool sorts() const { return plan.is_cells(); }
    // The arguments of a kernel that serves `amount` units of work.
    portable::SampleArguments arguments_of(Listing listing, std::uint32_t amount) const;
    void begin(std::uint32_t count);
    // Sorts the candidates as if the round had one part; with a radius field by order.
    void merge_parts(Snapshot& snapshot) const;

    std::vector<std::uint32_t> column_begins_;  // of the part, in draws; then its end
    Arrangement arrangement_;
    std::vector<Draw> arranged_;
    std::span<const Draw> draws_;  // part by part
    bool has_more_passes_ = false;
    HostMemory results_;
    HostMemory samples_alone_;  // so that the bins in results_ stay
    // The one of them that has the samples, from this byte on.
    const HostMemory* samples_in_ = nullptr;
    std::size_t samples_begin_ = 0;
};

}  // namespace lacuna::device
