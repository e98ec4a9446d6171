// What mode exact adds on the device: the sample grid, and the boxes that refine leaves.
#include "backends/device/boxes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "backends/columns.h"
#include "backends/device/scan.h"
#include "portable/status.h"

namespace lacuna::device {
namespace {

// Pieces beyond the number of the boxes cut; there are seldom as many.
constexpr std::uint32_t kSpareRoom = 1024;

// See Queue::launch.
constexpr std::uint64_t kScreenWork = 3;
constexpr std::uint64_t kCutWork = 16;
constexpr std::uint64_t kKeepWork = 4;

}  // namespace

Boxes::Boxes(RoundMemory& round) : round_(round) {
    const std::uint64_t cells = std::uint64_t{round_.plan.grid_columns} * round_.plan.grid_rows;
    Memory& m = round_.memory;
    for (Buffer* const coordinate : {&m.grid_x, &m.grid_y}) {
        round_.make_room(*coordinate, cells);
        round_.queue.fill(*coordinate, NO_SAMPLE, cells);
    }
    round_.make_room(m.bin_begins, round_.geometry.columns + std::uint64_t{1});
    make_boxes(m.box_x, m.box_begin, m.box_end, 0);
    make_tables(0);
}

void Boxes::make_boxes(Buffer& x, Buffer& begin, Buffer& end, std::uint64_t count) {
    for (Buffer* const coordinate : {&x, &begin, &end}) round_.make_room(*coordinate, count);
}

void Boxes::make_tables(std::uint64_t count) {
    Memory& m = round_.memory;
    for (Buffer* const table : {&m.piece_begin, &m.piece_end}) round_.make_room(*table, count);
    make_room_to_scan(round_, count);
}

// ------------------------------------------------------------------------------------ the rounds

void Boxes::locate() {
    round_.launch_over_draws<kernels::locate_in_boxes>(round_.arguments(), 1);
}

// Of all parts: no sample of the round is in the grid yet.
void Boxes::screen() {
    portable::DrawArguments arguments = round_.arguments(STATUS_COVERED);
    arguments.first = 0;
    arguments.count = round_.draw_count;
    round_.launch_over_draws<kernels::screen>(arguments, kScreenWork);
}

void Boxes::screen_again(std::uint32_t end) {
    portable::DrawArguments arguments = round_.arguments(STATUS_REJECTED);
    arguments.count = end;
    round_.launch_over_draws<kernels::screen>(arguments, kScreenWork);
}

void Boxes::insert() {
    round_.launch_over_draws<kernels::insert>(round_.arguments(), 1);
}

// ---------------------------------------------------------------------------------- refinements

void Boxes::unfold(const Memory& memory, portable::SlabArguments arguments, const Slab& slab,
                   bool is_counting) {
    arguments.block_bits = block_bits_of_scan(round_.plan.lines);
    arguments.is_counting = is_counting ? 1 : 0;
    launch<kernels::unfold>(round_.queue, memory, arguments, slab.lines(),
                            round_.geometry.capacity / (is_counting ? 8 : 4));
}

void Boxes::make_room_to_count() {
    make_tables(round_.plan.lines);
}

void Boxes::scan_lines() {
    scan(round_, round_.plan.lines);
}

void Boxes::make_room_for_lines() {
    count_ = total_.front();
    width_ = round_.plan.strip_width;
    Memory& m = round_.memory;
    make_boxes(m.box_x, m.box_begin, m.box_end, count_);
}

portable::StripArguments Boxes::strip_arguments(std::uint32_t served) const {
    const Span own = round_.plan.own_x();
    return {0,
            round_.queue.chunk_of(served),
            round_.geometry,
            count_,
            is_halved(),
            new_width_,
            kPasses - 1,
            block_bits_of_scan(strips()),
            new_room_,
            0,
            own.begin,
            own.end - own.begin};
}

void Boxes::refine(bool halve) {
    new_width_ = halve ? width_ / 2 : width_;
    new_room_ = count_ + kSpareRoom;
    make_tables(strips());
    const portable::StripArguments arguments = strip_arguments(count_);
    launch<kernels::cut>(round_.queue, round_.memory, arguments, items_of(count_, arguments.chunk),
                         (kCutWork << is_halved()) * arguments.chunk);
    scan(round_, strips());
    keep();
}

void Boxes::keep() {
    Memory& m = round_.memory;
    make_boxes(m.new_x, m.new_begin, m.new_end, new_room_);
    round_.make_room(m.free_lengths, new_room_);
    const portable::StripArguments arguments = strip_arguments(strips());
    launch<kernels::keep>(round_.queue, m, arguments, items_of(strips(), arguments.chunk),
                          kKeepWork * arguments.chunk);
    launch<kernels::find_bin_begins>(round_.queue, m, {0, kPasses - 1, round_.geometry, new_room_},
                                     round_.geometry.columns + std::uint64_t{1});
}

void Boxes::start_download() {
    round_.get<std::uint32_t>(round_.memory.total, total_);
    if (new_width_ == 0) return;
    bin_begins_.resize(round_.geometry.columns + std::size_t{1});
    free_lengths_.resize(new_room_);
    round_.get<std::uint32_t>(round_.memory.bin_begins, bin_begins_);
    round_.get<std::uint32_t>(round_.memory.free_lengths, free_lengths_);
}

bool Boxes::queue_rest() {
    if (new_width_ == 0 || total_.front() <= new_room_) return false;
    new_room_ = total_.front();
    keep();
    return true;
}

void Boxes::end_round() {
    if (new_width_ == 0) return;
    Memory& m = round_.memory;
    std::swap(m.box_x, m.new_x);
    std::swap(m.box_begin, m.new_begin);
    std::swap(m.box_end, m.new_end);
    width_ = std::exchange(new_width_, 0);
    count_ = total_.front();
}

// --------------------------------------------------------------------------------- for tests only

void Boxes::snapshot(Snapshot& snapshot) {
    const Memory& m = round_.memory;
    const std::size_t cells = std::size_t{round_.plan.grid_columns} * round_.plan.grid_rows;
    std::vector<std::uint32_t> grid_x(cells), grid_y(cells), x(count_), begin(count_), end(count_);
    round_.get<std::uint32_t>(m.grid_x, grid_x);
    round_.get<std::uint32_t>(m.grid_y, grid_y);
    round_.get<std::uint32_t>(m.box_x, x);
    round_.get<std::uint32_t>(m.box_begin, begin);
    round_.get<std::uint32_t>(m.box_end, end);
    round_.queue.wait();
    snapshot.box_width = width_;
    for (std::size_t i = 0; i < cells; ++i) snapshot.grid.push_back({grid_x[i], grid_y[i]});
    for (std::size_t i = 0; i < count_; ++i) snapshot.boxes.push_back({x[i], begin[i], end[i]});
}

void Boxes::restore(const Snapshot& snapshot) {
    const auto restore_words = [&](const Buffer& to, const auto& from, auto word_of) {
        std::vector<std::uint32_t> words;
        std::transform(from.begin(), from.end(), std::back_inserter(words), word_of);
        round_.put<std::uint32_t>(to, words);
        round_.queue.wait();
        return words;
    };
    Memory& m = round_.memory;
    restore_words(m.grid_x, snapshot.grid, [](Sample sample) { return sample.x; });
    restore_words(m.grid_y, snapshot.grid, [](Sample sample) { return sample.y; });

    new_width_ = 0;
    width_ = snapshot.box_width;
    count_ = static_cast<std::uint32_t>(snapshot.boxes.size());
    make_boxes(m.box_x, m.box_begin, m.box_end, count_);
    restore_words(m.box_x, snapshot.boxes, [](Box box) { return box.x; });
    restore_words(m.box_begin, snapshot.boxes, [](Box box) { return box.begin; });
    restore_words(m.box_end, snapshot.boxes, [](Box box) { return box.end; });
    free_lengths_.clear();
    for (const Box box : snapshot.boxes) free_lengths_.push_back(box.end - box.begin);
    bin_begins_.clear();
    for (const std::uint32_t line : first_lines(round_.plan, round_.geometry.columns)) {
        const auto first =
            std::partition_point(snapshot.boxes.begin(), snapshot.boxes.end(),
                                 [&](Box box) { return box.x / round_.plan.strip_width < line; });
        bin_begins_.push_back(static_cast<std::uint32_t>(first - snapshot.boxes.begin()));
    }
}

}  // namespace lacuna::device
