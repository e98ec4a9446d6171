// The active boxes of mode exact with one radius on a device: the samples in the grid cut them.
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "backends/columns.h"
#include "backends/device/boxes.h"

namespace lacuna::device {

GridBoxes::GridBoxes(RoundMemory& round, std::uint32_t width)
    : Boxes(round, {.strip_bits = 1, .words_of_bin = 1, .own = round.plan.own_x()}), width_(width) {
    round_.make_room(round_.memory.bin_begins, round_.geometry.columns + std::uint64_t{1});
}

void GridBoxes::put(std::span<const Box> boxes) {
    std::vector<std::uint32_t> lengths;
    for (const Box& box : boxes) lengths.push_back(box.end - box.begin);
    Boxes::put(boxes, std::move(lengths));
    bin_begins_.clear();
    for (const std::uint32_t line : first_lines(round_.plan, round_.geometry.columns)) {
        const auto first = std::partition_point(boxes.begin(), boxes.end(), [&](const auto& box) {
            return box.x / round_.plan.strip_width < line;
        });
        bin_begins_.push_back(static_cast<std::uint32_t>(first - boxes.begin()));
    }
}

void GridBoxes::queue_cut(bool) {
    launch_over_boxes<kernels::cut>(count_, round_.queue.chunk_of(count_),
                                    kCutWork << strip_bits());
}

void GridBoxes::queue_keep() {
    launch_over_boxes<kernels::keep>(count_, round_.queue.run_of(count_), kKeepWork);
}

void GridBoxes::queue_last() {
    if (!round_.plan.tells_orders) return;
    launch<kernels::find_bin_begins>(
        round_.queue, round_.memory,
        {.last_pass = kPasses - 1, .g = round_.geometry, .room = refinement_->room},
        round_.geometry.columns + std::uint64_t{1});
}

void GridBoxes::download() {
    Boxes::download();
    if (!round_.plan.tells_orders) return;
    bin_begins_.resize(round_.geometry.columns + std::size_t{1});
    round_.get<std::uint32_t>(round_.memory.bin_begins, bin_begins_);
}

void GridBoxes::end_round() {
    if (refinement_->is_halving) width_ /= 2;
    Boxes::end_round();
}

}  // namespace lacuna::device
