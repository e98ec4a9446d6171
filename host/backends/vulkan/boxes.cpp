// What mode exact adds on the device: the samples by cells, and the boxes that refine leaves.
#include "backends/vulkan/boxes.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "backends/columns.h"
#include "backends/vulkan/transfer.h"
#include "portable/column.h"
#include "portable/fate.h"

namespace lacuna::vulkan {
namespace {

// Counts that one invocation sums up.
constexpr std::uint32_t kBlock = 512;
// Pieces beyond the number of the boxes cut; there are seldom as many.
constexpr std::uint32_t kSpareRoom = 1024;

// See Engine::dispatch.
constexpr std::uint32_t kScreenWork = 3;
constexpr std::uint32_t kCutWork = 16;
constexpr std::uint32_t kKeepWork = 4;

std::uint32_t blocks_of(std::uint32_t count) {
    return (count + kBlock - 1) / kBlock;
}

}  // namespace

Boxes::Boxes(const Plan& plan, Engine& engine, const Kernels& kernels)
    : plan_(plan), engine_(engine), kernels_(kernels) {
    const std::uint64_t cells = std::uint64_t{plan.grid_columns} * plan.grid_rows;
    grid_x_ = words_on_device(engine, cells);
    grid_y_ = words_on_device(engine, cells);
    engine.fill(grid_x_, NO_SAMPLE, cells * kWord);
    engine.fill(grid_y_, NO_SAMPLE, cells * kWord);
    total_ = words_on_device(engine, 1);
    place_begins_made_ = words_on_device(engine, count_columns(plan) + std::uint64_t{1});
    total_down_ = host_copy_of(engine, total_, Engine::Memory::download);
    place_begins_down_ = host_copy_of(engine, place_begins_made_, Engine::Memory::download);
    make_room(now_, 0);
    make_room(next_, 0);
    make_tables(plan.lines);
    engine.barrier();
}

std::uint32_t Boxes::total() const {
    return total_down_.as<std::uint32_t>().front();
}

std::span<const std::uint32_t> Boxes::lengths() const {
    return lengths_down_.as<std::uint32_t>().first(count_);
}

void Boxes::make_room(Set& set, std::uint32_t count) {
    if (count <= set.room && set.room != 0) return;
    set.room = std::max(count, kSpareRoom);
    set.x = words_on_device(engine_, set.room);
    set.begin = words_on_device(engine_, set.room);
    set.end = words_on_device(engine_, set.room);
    if (lengths_.bytes() / kWord >= set.room) return;
    lengths_ = words_on_device(engine_, set.room);
    lengths_down_ = host_copy_of(engine_, lengths_, Engine::Memory::download);
}

// For so many lines or strips.
void Boxes::make_tables(std::uint32_t count) {
    if (count <= table_room_) return;
    table_room_ = count;
    counts_ = words_on_device(engine_, count);
    piece_begin_ = words_on_device(engine_, count);
    piece_end_ = words_on_device(engine_, count);
    sums_ = words_on_device(engine_, blocks_of(count));
}

// ------------------------------------------------------------------------------------ the rounds

void Boxes::locate(const Memory& m, std::uint32_t chunk) {
    engine_.dispatch(kernels_.locate_in_boxes, {now_.x, now_.begin, m.draws, m.located},
                     LocateInBoxesArguments{0, m.geometry, m.draw_count, chunk},
                     (m.draw_count + chunk - 1) / chunk, chunk);
}

void Boxes::screen(const Memory& m, std::uint32_t chunk) {
    engine_.dispatch(kernels_.screen, {m.candidates, grid_x_, grid_y_, m.fates, m.samples},
                     ScreenArguments{0, m.geometry, m.draw_count, chunk},
                     (m.draw_count + chunk - 1) / chunk, chunk * kScreenWork);
    engine_.barrier();
}

void Boxes::insert(const Memory& m) {
    engine_.dispatch(kernels_.insert, {m.undecided, m.candidates, m.fates, grid_x_, grid_y_},
                     InsertArguments{0, m.geometry, m.draw_count, kPasses - 1}, m.draw_count);
    engine_.barrier();
}

// ---------------------------------------------------------------------------------- refinements

// counts_ and then the sums of its blocks become prefix sums; total_ the sum of all.
void Boxes::scan(const Memory& m, std::uint32_t count) {
    const std::uint32_t blocks = blocks_of(count);
    engine_.fill(total_, 0, kWord);
    engine_.barrier();
    engine_.dispatch(kernels_.scan, {counts_, sums_, m.failure}, ScanArguments{0, count, kBlock},
                     blocks, kBlock / 8);
    engine_.barrier();
    engine_.dispatch(kernels_.scan, {sums_, total_, m.failure}, ScanArguments{0, blocks, blocks},
                     std::min(blocks, 1u), blocks / 8);
    engine_.barrier();
}

void Boxes::count_spans(const Memory& m) {
    for (std::size_t i = 0; i < m.slabs.size(); ++i) {
        const device::Slab& slab = m.slabs[i];
        engine_.dispatch(
            kernels_.unfold,
            {m.spans[i], m.span_counts, counts_, sums_, now_.x, now_.begin, now_.end, m.failure},
            UnfoldArguments{0, m.geometry, slab.first_line, slab.end_line, kBlock, 1}, slab.lines(),
            m.geometry.capacity / 8);
    }
    engine_.barrier();
    scan(m, plan_.lines);
}

void Boxes::unfold(const Memory& m) {
    count_ = total();
    width_ = plan_.strip_width;
    make_room(now_, count_);
    for (std::size_t i = 0; i < m.slabs.size(); ++i) {
        const device::Slab& slab = m.slabs[i];
        engine_.dispatch(
            kernels_.unfold,
            {m.spans[i], m.span_counts, counts_, sums_, now_.x, now_.begin, now_.end, m.failure},
            UnfoldArguments{0, m.geometry, slab.first_line, slab.end_line, kBlock, 0}, slab.lines(),
            m.geometry.capacity / 4);
    }
    engine_.barrier();
}

void Boxes::refine(const Memory& m, bool halve) {
    new_width_ = halve ? width_ / 2 : width_;
    new_room_ = count_ + kSpareRoom;
    make_room(next_, new_room_);
    make_tables(strips());
    cut(m);
    scan(m, strips());
    keep(m);
}

void Boxes::cut(const Memory& m) {
    engine_.dispatch(kernels_.cut,
                     {m.undecided, grid_x_, grid_y_, now_.x, now_.begin, now_.end, counts_,
                      piece_begin_, piece_end_, m.failure},
                     CutArguments{0, m.geometry, strips(), is_halved(), new_width_, kPasses - 1},
                     strips(), kCutWork);
    engine_.barrier();
}

void Boxes::keep(const Memory& m) {
    engine_.dispatch(
        kernels_.keep,
        {m.undecided, grid_x_, grid_y_, now_.x, now_.begin, now_.end, counts_, piece_begin_,
         piece_end_, sums_, next_.x, next_.begin, next_.end, lengths_, m.failure},
        KeepArguments{0, m.geometry, strips(), is_halved(), new_width_, kPasses - 1, kBlock,
                      new_room_},
        strips(), kKeepWork);
    engine_.barrier();
    find_place_begins(m);
}

void Boxes::find_place_begins(const Memory& m) {
    engine_.dispatch(kernels_.find_place_begins, {next_.x, total_, place_begins_made_},
                     FindPlaceBeginsArguments{0, m.geometry, new_room_}, m.geometry.columns + 1);
    engine_.barrier();
}

void Boxes::download() {
    engine_.copy(total_, total_down_, kWord);
    if (new_width_ == 0) return;
    engine_.copy(place_begins_made_, place_begins_down_, place_begins_made_.bytes());
    engine_.copy(lengths_, lengths_down_, new_room_ * kWord);
}

bool Boxes::lacks_room() const {
    return total() > new_room_;
}

void Boxes::make_room_and_keep(const Memory& m) {
    new_room_ = total();
    make_room(next_, new_room_);
    keep(m);
}

void Boxes::accept() {
    std::swap(now_, next_);
    width_ = std::exchange(new_width_, 0);
    count_ = total();
    const auto begins = place_begins_down_.as<std::uint32_t>();
    place_begins_.assign(begins.begin(), begins.begin() + count_columns(plan_) + 1);
}

// --------------------------------------------------------------------------------- for tests only

void Boxes::snapshot(Snapshot& snapshot) {
    const std::size_t cells = std::size_t{plan_.grid_columns} * plan_.grid_rows;
    const auto grid_x = read<std::uint32_t>(engine_, grid_x_, cells);
    const auto grid_y = read<std::uint32_t>(engine_, grid_y_, cells);
    for (std::size_t i = 0; i < cells; ++i) snapshot.grid.push_back({grid_x[i], grid_y[i]});
    snapshot.box_width = width_;
    const auto x = read<std::uint32_t>(engine_, now_.x, count_);
    const auto begin = read<std::uint32_t>(engine_, now_.begin, count_);
    const auto end = read<std::uint32_t>(engine_, now_.end, count_);
    for (std::size_t i = 0; i < count_; ++i) snapshot.boxes.push_back({x[i], begin[i], end[i]});
}

void Boxes::restore(const Snapshot& snapshot) {
    const auto restore_words = [&](const Buffer& to, const auto& from, auto word_of) {
        std::vector<std::uint32_t> words;
        std::transform(from.begin(), from.end(), std::back_inserter(words), word_of);
        write<std::uint32_t>(engine_, to, words);
    };
    restore_words(grid_x_, snapshot.grid, [](Sample cell) { return cell.x; });
    restore_words(grid_y_, snapshot.grid, [](Sample cell) { return cell.y; });

    new_width_ = 0;
    width_ = snapshot.box_width;
    count_ = static_cast<std::uint32_t>(snapshot.boxes.size());
    make_room(now_, count_);
    restore_words(now_.x, snapshot.boxes, [](Box box) { return box.x; });
    restore_words(now_.begin, snapshot.boxes, [](Box box) { return box.begin; });
    restore_words(now_.end, snapshot.boxes, [](Box box) { return box.end; });
    engine_.wait();

    const std::span<std::uint32_t> lengths = lengths_down_.as<std::uint32_t>();
    std::transform(snapshot.boxes.begin(), snapshot.boxes.end(), lengths.begin(),
                   [](Box box) { return box.end - box.begin; });
    place_begins_.clear();
    for (const std::uint32_t line : first_lines(plan_, count_columns(plan_))) {
        const auto first =
            std::partition_point(snapshot.boxes.begin(), snapshot.boxes.end(),
                                 [&](Box box) { return box.x / plan_.strip_width < line; });
        place_begins_.push_back(static_cast<std::uint32_t>(first - snapshot.boxes.begin()));
    }
}

}  // namespace lacuna::vulkan
