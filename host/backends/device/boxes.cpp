// The active boxes of mode exact on a device. The kernel cut counts pieces, keep writes them.
#include "backends/device/boxes.h"

#include <algorithm>
#include <utility>

#include "backends/device/scan.h"

namespace lacuna::device {
namespace {

// Room for pieces beyond the expected number, which is seldom reached.
constexpr std::uint32_t kSpareRoom = 1024;

}  // namespace

std::vector<Box> Boxes::get() const {
    std::vector<Box> boxes(count_);
    round_.get<Box>(round_.memory.boxes, boxes);
    round_.queue.wait();
    return boxes;
}

void Boxes::make_room(std::uint32_t count) {
    count_ = count;
    round_.make_room(round_.memory.boxes, 4 * std::uint64_t{count});
}

portable::StripArguments Boxes::arguments(std::uint32_t chunk) const {
    return {.chunk = chunk,
            .g = round_.geometry,
            .boxes = count_,
            .strip_bits = strip_bits(),
            .last_pass = kPasses - 1,
            .block_bits = block_bits_of_scan(count_ + portable::words_of_column(round_.draw_count)),
            .room = refinement_->room,
            .first_recent = refinement_->first_recent,
            .own_begin = kind_.own.begin,
            .own_width = kind_.own.end - kind_.own.begin,
            .least_to_split = least_to_split()};
}

void Boxes::refine(bool halve, std::uint32_t first_recent) {
    refinement_ = {halve, first_recent, count_ + more_boxes(halve) + kSpareRoom};
    // Room for the largest number of boxes that is likely in any round: the number grows for some
    // rounds, and a driver clears new memory page by page.
    const std::uint64_t boxes = std::max<std::uint64_t>(count_, room_for_boxes(round_.plan));
    make_room_to_scan(round_, boxes + portable::words_of_column(round_.draw_count));
    make_room_for_pieces();
    make_room_to_cut(boxes, halve);
    queue_cut(halve);
    round_.count_samples(listing());
    keep();
}

void Boxes::make_room_to_cut(std::uint64_t boxes, bool) {
    round_.make_room(round_.memory.strip_pieces, 2 * boxes << strip_bits());
}

RoundMemory::Listing Boxes::listing() const {
    return {.counts_before = count_,
            .words_of_bin = kind_.words_of_bin,
            .bins = 0,
            .room = refinement_->room};
}

void Boxes::make_room_for_pieces() {
    const std::uint64_t room =
        std::max<std::uint64_t>(refinement_->room, room_for_boxes(round_.plan));
    round_.make_room(round_.memory.*kind_.new_boxes, 4 * room);
    make_room_to_keep(room);
    round_.make_room_for_listing({count_, kind_.words_of_bin, 0, static_cast<std::uint32_t>(room)});
}

void Boxes::keep() {
    queue_keep();
    list_samples(listing());
    queue_last();
}

bool Boxes::queue_rest() {
    if (!refinement_ || round_.new_boxes() <= refinement_->room) return false;
    refinement_->room = round_.new_boxes();
    make_room_for_pieces();
    keep();
    return true;
}

void Boxes::download() {
    sizes_ = round_.download_results(std::size_t{kind_.words_of_bin} * round_.new_boxes());
}

void Boxes::end_round() {
    std::swap(round_.memory.*kind_.boxes, round_.memory.*kind_.new_boxes);
    refinement_.reset();
    count_ = round_.new_boxes();
}

}  // namespace lacuna::device
