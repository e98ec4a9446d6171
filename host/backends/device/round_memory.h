// What every mode keeps on the device of a round: its draws, their candidates, what becomes of
// them, and whether the work was finished.
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

namespace lacuna::device {

// Passes of admit queued at a time; one that finds nothing undecided returns at once. Most rounds
// settle in five or six.
inline constexpr std::uint32_t kPasses = 8;

// The queue may use the host's vectors until it has been waited for.
struct RoundMemory {
    RoundMemory(const Plan& plan, Queue& queue);

    // The draws, part by part, on their way up; makes room for what becomes of them. bin_begins:
    // see columns.h.
    void upload(std::span<const Draw> draws, std::span<const std::uint32_t> bin_begins,
                PartLimits limits);
    std::uint32_t parts() const { return static_cast<std::uint32_t>(arrangement_.ends.size()); }
    // The commands that follow are about one part: its table is on its way up. Where there are
    // several, the queue must have been waited for.
    void open_part(std::uint32_t number);
    // Waits, and tells of the parts from one on which have no draw left undecided.
    void find_done(std::uint32_t first, std::vector<bool>& is_done);
    std::span<const Draw> draws_of_part() const {
        return draws_.subspan(part.begin, part.end - part.begin);
    }
    // What was located of the part, sorted by column and y.
    void sort();
    // For passes after the first kPasses: all but the last count as done. From then on an item of
    // admit serves one candidate: where they crowd, an item leaves some of a longer chunk to the
    // next pass (bodies/common/admit.h), and those that it never comes to may be what the others
    // wait for.
    void begin_more_passes();
    std::uint32_t chunk_of_admit(std::uint32_t chunk) const { return has_more_passes_ ? 1 : chunk; }
    // Of a draw, see Queue::launch: the first pass looks at all of them, the others at few.
    static std::uint64_t admit_work(std::uint32_t pass) { return pass == 0 ? 6 : 1; }

    // Flags on their way down that tell, after the wait, whether the passes have settled admission;
    // and by_order, which a round hands back. throw_if_failed throws DeviceError where a kernel
    // could not finish its work.
    void start_download(bool with_samples);
    bool is_unsettled() const { return undecided_.back() != 0; }
    void throw_if_failed() const;

    // Arguments of the kernels over the part's draws, and their launch.
    portable::DrawArguments arguments() const;
    template <typename Kernel>
    void launch_over_draws(portable::DrawArguments arguments, std::uint64_t work_of_draw) {
        launch<Kernel>(queue, memory, arguments,
                       items_of(arguments.count - arguments.first, arguments.chunk),
                       work_of_draw * arguments.chunk);
    }
    // Draws of the part, and of a column of it, on average and rounded up.
    std::uint32_t part_count() const { return part.end - part.begin; }
    std::uint32_t draws_per_column() const { return part_count() / geometry.columns + 1; }

    // A table on its way up, and one on its way down.
    template <typename T>
    void put(const Buffer& to, std::span<const T> from, std::uint64_t first_word = 0) {
        queue.upload(to, std::as_bytes(from), first_word * kWord);
    }
    template <typename T>
    void get(const Buffer& from, std::span<T> to) {
        queue.download(from, std::as_writable_bytes(to));
    }
    // Room for so many words, or more of what there was; what was there is lost.
    void make_room(Buffer& buffer, std::uint64_t words) const;
    // Room with these at its begin, for kernels to write to, and zeros: Oclgrind takes what kernels
    // write beyond what was uploaded last for uninitialized. Waits.
    template <typename T>
    void put_in_room(Buffer& buffer, std::span<const T> from) {
        make_room(buffer, from.size_bytes() / kWord);
        const std::vector<std::byte> rest(buffer.bytes() - from.size_bytes());
        put(buffer, from);
        queue.upload(buffer, rest, from.size_bytes());
        queue.wait();
    }
    // A buffer with these words.
    Buffer copy_of(std::span<const std::uint32_t> words);

    // Once they were sorted. Waits.
    std::vector<Candidate> candidates();

    void snapshot(Snapshot& snapshot);
    // The candidates, part by part, to be sorted; and then what became of them.
    void restore_candidates(const Snapshot& snapshot, PartLimits limits);
    void restore_statuses(const Snapshot& snapshot);

    const Plan& plan;
    Queue& queue;
    Memory memory;
    portable::Geometry geometry;
    std::uint32_t draw_count = 0;              // of the round
    Range part{0, 0};                          // of the draws
    std::vector<std::uint32_t> column_begins;  // of the part, in draws; columns + 1
    std::vector<Sample> by_order;              // of each draw, see take_admitted

private:
    void begin(std::uint32_t count);
    // Candidates in the order of one part.
    void merge_parts(Snapshot& snapshot) const;

    Arrangement arrangement_;
    std::vector<Draw> arranged_;
    std::span<const Draw> draws_;  // part by part
    bool has_more_passes_ = false;
    std::array<std::uint32_t, kPasses> undecided_{};
    std::array<std::uint32_t, 1> failure_{};
};

}  // namespace lacuna::device
