// What every mode keeps on the device of a round: its draws, their candidates, what becomes of
// them, and whether the work was finished.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "backends/device/kernels.h"
#include "backends/device/queue.h"
#include "plan/plan.h"

namespace lacuna::device {

// Passes of admit queued at a time; one that finds nothing undecided returns at once. Most rounds
// settle in five or six.
inline constexpr std::uint32_t kPasses = 8;

// The queue may use the host's vectors until it has been waited for.
struct RoundMemory {
    RoundMemory(const Plan& plan, Queue& queue);

    // The draws and their table on their way up; makes room for what becomes of them. place_begins:
    // see columns.h.
    void upload(std::span<const Draw> draws, std::span<const std::uint32_t> place_begins);
    // What was located, sorted by column and y.
    void sort();
    // For passes after the first kPasses: all but the last count as done.
    void begin_more_passes();

    // What a round hands back on its way down: by_order, and flags that tell, after the wait,
    // whether the passes have settled admission. throw_if_failed throws DeviceError where a kernel
    // could not finish its work.
    void start_download();
    bool is_unsettled() const { return undecided_.back() != 0; }
    void throw_if_failed() const;

    // Arguments of the kernels over draws, and the number of items that serve all.
    portable::DrawArguments arguments(std::uint32_t pass = kPasses - 1) const;
    template <typename Kernel>
    void launch_over_draws(portable::DrawArguments arguments, std::uint64_t work_of_draw) {
        launch<Kernel>(queue, memory, arguments, items_of(draw_count, arguments.chunk),
                       work_of_draw * arguments.chunk);
    }
    // Draws of a column, on average and rounded up.
    std::uint32_t draws_per_column() const { return draw_count / geometry.columns + 1; }

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
    // A buffer with these words.
    Buffer copy_of(std::span<const std::uint32_t> words);

    void snapshot(Snapshot& snapshot);
    // The candidates, to be sorted; and then what became of them.
    void restore_candidates(const Snapshot& snapshot);
    void restore_fates(const Snapshot& snapshot);

    const Plan& plan;
    Queue& queue;
    Memory memory;
    portable::Geometry geometry;
    std::uint32_t draw_count = 0;
    std::vector<std::uint32_t> column_begins;  // in draws; columns + 1
    std::vector<Sample> by_order;              // of each draw, see take_admitted

private:
    void begin(std::uint32_t count);

    std::array<std::uint32_t, kPasses> undecided_{};
    std::array<std::uint32_t, 1> failure_{};
};

}  // namespace lacuna::device
