// Refining the active boxes of mode exact with a radius field on a device.
#include "backends/device/list_boxes.h"

#include <limits>
#include <utility>

#include "plan/first_free.h"

namespace lacuna::device {
namespace {

// The work of a box, see Queue::launch.
constexpr std::uint64_t kSplitWork = 8;
constexpr std::uint64_t kMeasureWork = 2;

// There is no halo, and x reaches over all copies.
constexpr Span kEverywhere{0, std::numeric_limits<std::uint32_t>::max()};

}  // namespace

ListBoxes::ListBoxes(RoundMemory& round)
    : Boxes(round, {.strip_bits = 2, .words_of_bin = 2, .own = kEverywhere}) {}

void ListBoxes::put(std::span<const Box> boxes, std::span<const std::uint32_t> origins) {
    round_.put_in_room<std::uint32_t>(round_.memory.origins, origins);
    std::vector<std::uint32_t> sizes;
    for (const Box& box : boxes) sizes.push_back(box.end - box.begin);
    for (const Box& box : boxes) sizes.push_back(box.width);
    Boxes::put(boxes, std::move(sizes));
    copy_ends_ = copy_ends_of(round_.plan, boxes);
}

void ListBoxes::make_room_to_cut(std::uint64_t boxes, bool halve) {
    Boxes::make_room_to_cut(boxes, halve);
    round_.make_room(round_.memory.borders, halve ? 4 * boxes : 0);
    round_.make_room(round_.memory.strip_radii, halve ? 4 * boxes : 0);
}

void ListBoxes::make_room_to_keep(std::uint64_t room) {
    round_.make_room(round_.memory.new_origins, 2 * room);
}

void ListBoxes::queue_cut(bool halve) {
    if (halve) launch_over_boxes<kernels::split>(count_, round_.queue.run_of(count_), kSplitWork);
    launch_over_boxes<kernels::cut_with_field>(count_, round_.queue.chunk_of(count_),
                                               kCutWork << strip_bits());
}

void ListBoxes::queue_keep() {
    // A box with many pieces walks its list of samples for each: such work is not put together in
    // one item on devices that limit the turns of loops (portable/failure.h).
    launch_over_boxes<kernels::keep_with_field>(count_, round_.queue.chunk_of(count_), kKeepWork);
    const std::uint32_t room = refinement_->room;
    launch_over_boxes<kernels::measure>(room, round_.queue.run_of(room), kMeasureWork);
}

void ListBoxes::download() {
    Boxes::download();
    if (!round_.plan.field().copies.are_several()) return;
    new_boxes_.resize(round_.new_boxes());
    round_.get<Box>(round_.memory.new_boxes, new_boxes_);
}

void ListBoxes::end_round() {
    std::swap(round_.memory.origins, round_.memory.new_origins);
    Boxes::end_round();
    copy_ends_ = copy_ends_of(round_.plan, new_boxes_);
}

}  // namespace lacuna::device
