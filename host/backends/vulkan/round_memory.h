// What every mode keeps on the device of a round: its draws, their candidates, what becomes of
// them, and whether the work was finished.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "backends/vulkan/engine.h"
#include "backends/vulkan/programs.h"

namespace lacuna::vulkan {

inline constexpr std::uint32_t kPasses = 8;  // of admit at a time; more are rarely needed

struct RoundMemory {
    RoundMemory(const Plan& plan, Engine& engine);

    // The draws and their table on their way up, and what a round hands back on its way down: to
    // be found in the `_down` buffers after the wait. Recorded; the barrier after `upload` is the
    // caller's. place_begins: see columns.h.
    void upload(std::span<const Draw> draws, std::span<const std::uint32_t> place_begins);
    void download();
    // What was located, sorted by column and y. Recorded.
    void sort(const Kernel& sort_columns);
    // For passes after the first kPasses: all but the last count as done. Recorded.
    void begin_more_passes();
    // After a download: throws DeviceError when a verb could not finish.
    void throw_if_failed() const;
    bool is_unsettled() const { return undecided_down.as<std::uint32_t>()[kPasses - 1] != 0; }

    // Draws of a column, on average and rounded up.
    std::uint32_t draws_per_column() const { return draw_count / geometry.columns + 1; }

    void snapshot_round(Snapshot& snapshot);
    // The candidates, to be sorted; and then what became of them.
    void begin_restored_round(const Snapshot& snapshot);
    void restore_fates(const Snapshot& snapshot);

    const Plan& plan;
    Engine& engine;
    Geometry geometry;

    // `undecided` has a count for each pass.
    std::uint32_t draw_count = 0;
    Buffer draws, located, buckets, candidates, fates, samples;
    Buffer column_begins, undecided, failure;

    Buffer draws_up, column_begins_up;
    Buffer samples_down, undecided_down, failure_down;

protected:
    std::vector<std::uint32_t> column_begins_;

private:
    void begin_round(std::uint32_t count);
    void make_room(std::uint32_t count);

    std::uint32_t draw_room_ = 0;
};

// A processor walks a line once for so many draws; a graphics card wants an invocation a draw.
inline std::uint32_t served_together(const Engine& engine) {
    constexpr std::uint32_t kServedTogether = 32;
    return engine.device().kind == "cpu" ? kServedTogether : 1;
}

}  // namespace lacuna::vulkan
