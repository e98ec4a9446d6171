// The active boxes of mode exact on a device. The kernel cut counts pieces, keep writes them.
#include "backends/device/boxes.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "backends/columns.h"
#include "backends/device/scan.h"
#include "plan/first_free.h"

namespace lacuna::device {
namespace {

// Room for pieces beyond the expected number, which is seldom reached.
constexpr std::uint32_t kSpareRoom = 1024;

// The work of a box, see Queue::launch.
constexpr std::uint64_t kCutWork = 16;
constexpr std::uint64_t kKeepWork = 4;
constexpr std::uint64_t kSplitWork = 8;
constexpr std::uint64_t kMeasureWork = 2;

static_assert(sizeof(Box) == 4 * kWord);

}  // namespace

Boxes::Boxes(RoundMemory& round, std::uint32_t width) : round_(round), width_(width) {
    round_.make_room(round_.memory.bin_begins, round_.geometry.columns + std::uint64_t{1});
}

void Boxes::put(std::span<const Box> boxes, std::span<const std::uint32_t> origins) {
    count_ = static_cast<std::uint32_t>(boxes.size());
    round_.put_in_room<Box>(round_.memory.boxes, boxes);
    if (has_field()) round_.put_in_room<std::uint32_t>(round_.memory.origins, origins);
    set_sizes(boxes);
    bin_begins_.clear();
    if (has_field()) return;
    for (const std::uint32_t line : first_lines(round_.plan, round_.geometry.columns)) {
        const auto first = std::partition_point(boxes.begin(), boxes.end(), [&](const auto& box) {
            return box.x / round_.plan.strip_width < line;
        });
        bin_begins_.push_back(static_cast<std::uint32_t>(first - boxes.begin()));
    }
}

std::vector<Box> Boxes::get() const {
    std::vector<Box> boxes(count_);
    round_.get<Box>(round_.memory.boxes, boxes);
    round_.queue.wait();
    return boxes;
}

void Boxes::set_sizes(std::span<const Box> boxes) {
    first_sizes_.clear();
    for (const Box& box : boxes) first_sizes_.push_back(box.end - box.begin);
    for (const Box& box : boxes.first(has_field() ? boxes.size() : 0))
        first_sizes_.push_back(box.width);
    sizes_ = first_sizes_;
    if (has_field()) sheet_ends_ = sheet_ends_of(round_.plan, boxes);
}

void Boxes::make_room(std::uint32_t count) {
    count_ = count;
    round_.make_room(round_.memory.boxes, 4 * std::uint64_t{count});
}

// ---------------------------------------------------------------------------------- refinements

std::uint32_t Boxes::strip_bits() const {
    if (!refinement_->is_halving) return 0;
    return has_field() ? 2 : 1;
}

// The samples of a round split few boxes. In uniform sets, at least half of all halves are covered.
// With a radius field the number of boxes stays about the same, or grows if pixels are unlike.
std::uint32_t Boxes::expected_pieces(bool halve) const {
    const std::uint32_t more = !has_field() ? 0 : halve ? count_ : count_ / 32;
    return count_ + more + kSpareRoom;
}

template <typename Kernel>
void Boxes::launch_over_boxes(std::uint32_t count, std::uint32_t chunk, std::uint64_t work_of_box) {
    // With a radius field there is no halo, and x reaches over all sheets.
    const Span own = has_field() ? Span{0, ~std::uint32_t{0}} : round_.plan.own_x();
    const portable::StripArguments arguments{
        .chunk = chunk,
        .g = round_.geometry,
        .boxes = count_,
        .strip_bits = strip_bits(),
        .last_pass = kPasses - 1,
        .block_bits = block_bits_of_scan(count_ + portable::words_of_column(round_.draw_count)),
        .room = refinement_->room,
        .first_recent = refinement_->first_recent,
        .own_begin = own.begin,
        .own_width = own.end - own.begin};
    launch<Kernel>(round_.queue, round_.memory, arguments, items_of(count, chunk),
                   work_of_box * chunk);
}

void Boxes::refine(bool halve, std::uint32_t first_recent) {
    refinement_ = {halve, first_recent, expected_pieces(halve)};
    Memory& m = round_.memory;
    // Room for the largest number of boxes that is likely in any round: the number grows for some
    // rounds, and a driver clears new memory page by page.
    const std::uint64_t boxes = std::max<std::uint64_t>(count_, room_for_boxes(round_.plan));
    round_.make_room(m.strip_pieces, 2 * boxes << strip_bits());
    make_room_to_scan(round_, boxes + portable::words_of_column(round_.draw_count));
    make_room_for_pieces();
    if (has_field()) {
        round_.make_room(m.borders, halve ? 4 * boxes : 0);
        round_.make_room(m.strip_radii, halve ? 4 * boxes : 0);
        if (halve)
            launch_over_boxes<kernels::split>(count_, round_.queue.run_of(count_), kSplitWork);
        launch_over_boxes<kernels::cut_with_field>(count_, round_.queue.chunk_of(count_),
                                                   kCutWork << strip_bits());
    } else {
        launch_over_boxes<kernels::cut>(count_, round_.queue.chunk_of(count_),
                                        kCutWork << strip_bits());
    }
    round_.count_samples(listing());
    keep();
}

RoundMemory::Listing Boxes::listing() const {
    return {.counts_before = count_,
            .words_of_bin = has_field() ? 2u : 1u,
            .bins = 0,
            .room = refinement_->room};
}

void Boxes::make_room_for_pieces() {
    Memory& m = round_.memory;
    const std::uint64_t room =
        std::max<std::uint64_t>(refinement_->room, room_for_boxes(round_.plan));
    round_.make_room(m.new_boxes, 4 * room);
    if (has_field()) round_.make_room(m.new_origins, 2 * room);
    round_.make_room_for_listing(
        {count_, listing().words_of_bin, 0, static_cast<std::uint32_t>(room)});
}

void Boxes::keep() {
    if (has_field()) {
        // A box with many pieces walks its list of samples for each: such work is not put together
        // in one item on devices that limit the turns of loops (portable/failure.h).
        launch_over_boxes<kernels::keep_with_field>(count_, round_.queue.chunk_of(count_),
                                                    kKeepWork);
        const std::uint32_t room = refinement_->room;
        launch_over_boxes<kernels::measure>(room, round_.queue.run_of(room), kMeasureWork);
    } else {
        launch_over_boxes<kernels::keep>(count_, round_.queue.run_of(count_), kKeepWork);
    }
    round_.list_samples(listing());
    if (has_field() || !round_.plan.tells_orders) return;
    launch<kernels::find_bin_begins>(
        round_.queue, round_.memory,
        {.last_pass = kPasses - 1, .g = round_.geometry, .room = refinement_->room},
        round_.geometry.columns + std::uint64_t{1});
}

bool Boxes::queue_rest() {
    if (!refinement_ || round_.new_boxes() <= refinement_->room) return false;
    refinement_->room = round_.new_boxes();
    make_room_for_pieces();
    keep();
    return true;
}

void Boxes::download() {
    sizes_ = round_.download_results(std::size_t{listing().words_of_bin} * round_.new_boxes());
    if (has_field() && round_.plan.field().sheets.are_several()) {
        new_boxes_.resize(round_.new_boxes());
        round_.get<Box>(round_.memory.new_boxes, new_boxes_);
    }
    if (has_field() || !round_.plan.tells_orders) return;
    bin_begins_.resize(round_.geometry.columns + std::size_t{1});
    round_.get<std::uint32_t>(round_.memory.bin_begins, bin_begins_);
}

void Boxes::end_round() {
    Memory& m = round_.memory;
    std::swap(m.boxes, m.new_boxes);
    std::swap(m.origins, m.new_origins);
    if (refinement_->is_halving) width_ /= 2;
    refinement_.reset();
    count_ = round_.new_boxes();
    if (has_field()) sheet_ends_ = sheet_ends_of(round_.plan, new_boxes_);
}

}  // namespace lacuna::device
