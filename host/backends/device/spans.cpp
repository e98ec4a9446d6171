// The bins of modes lines and exact on a device: the free spans of lines, in slabs, until exact
// refines them into boxes.
#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "backends/columns.h"
#include "backends/device/bins.h"
#include "backends/device/boxes.h"
#include "backends/device/grid.h"
#include "backends/device/scan.h"

namespace lacuna::device {
namespace {

// See Queue::launch.
constexpr std::uint64_t kLocateWork = 4;
constexpr std::uint64_t kSubtractWork = 8;
constexpr std::uint64_t kTileWork = 1;

std::uint32_t rows_of_tile(const Queue& queue, const Tuning& tuning) {
    if (tuning.rows_of_tile != 0) return tuning.rows_of_tile;
    return queue.device().kind == "cpu" ? std::numeric_limits<std::uint32_t>::max() : kRowsOfTile;
}

class Spans : public Bins {
public:
    Spans(RoundMemory& round, const Tuning& tuning)
        : Bins(round),
          tiles_(tiles_of(round.plan, rows_of_tile(round.queue, tuning))),
          largest_slab_(tuning.largest_slab_bytes != 0 ? tuning.largest_slab_bytes
                                                       : round.queue.device().largest_buffer_bytes),
          first_lines_(first_lines(round.plan, round.geometry.columns)),
          grid_(round) {
        Memory& m = round_.memory;
        for (Buffer* const of_tile : {&m.span_counts, &m.tile_lengths, &m.tile_begins})
            round_.make_room(*of_tile, all_tiles());
        round_.make_room_for_listing(listing());
        make_slabs(first_tile_capacity(round_.plan, tiles_));
        for (std::size_t i = 0; i < slabs_.size(); ++i)
            launch_over_tiles<kernels::open_lines>(i, arguments_of(i), kTileWork);
        sum_tiles();
        first_lengths_.assign(round_.plan.lines, round_.plan.height);
        free_lengths_ = first_lengths_;
        round_.queue.wait();  // so that another backend may use the device before the first round
    }

    std::span<const std::uint32_t> begins() const override {
        return boxes_ ? boxes_->begins() : first_lines_;
    }

    PartLimits part_limits(std::uint32_t count) const override {
        const Plan& plan = round_.plan;
        const double disk_area = std::min(2.0 * plan.radius / plan.width, 1.0) *
                                 std::min(2.0 * plan.radius / plan.height, 1.0);
        return limits_by_area(count, disk_area, disk_area);
    }

    void begin_round() override {
        if (boxes_) return;
        grid_.begin_new_cells();
        round_.make_room_for_listing(listing());
    }

    void locate(std::span<const Draw> draws) override {
        if (boxes_)
            return round_.launch_over_draws<kernels::locate_in_boxes>(round_.arguments(), 1);
        const std::uint32_t chunk = round_.queue.chunk_of(round_.part_count());
        for (std::size_t i = 0; i < slabs_.size(); ++i) {
            const Range range = draws_of(slabs_[i], draws);
            portable::SlabArguments arguments = arguments_of(i);
            arguments.chunk = chunk;
            arguments.first_draw = round_.part.begin + range.begin;
            arguments.end_draw = round_.part.begin + range.end;
            launch<kernels::locate>(round_.queue, memory_of(i), arguments,
                                    items_of(range.end - range.begin, chunk), kLocateWork * chunk);
        }
    }

    void screen(Range draws, std::uint32_t status, bool opens) override {
        grid_.screen(draws, status, opens);
    }

    void admit(std::uint32_t pass) override {
        round_.admit<kernels::admit>(round_.arguments(), pass,
                                     round_.queue.run_of(round_.part_count()));
    }

    void subtract() override {
        take_out();
        cut_spans();
        round_.count_samples(listing());
        round_.list_samples(listing());
    }

    void take_out() override { grid_.insert(!boxes_); }

    void refine(bool halve) override {
        if (!round_.plan.is_exact()) throw std::logic_error("mode lines has nothing to refine");
        if (!boxes_) turn_into_boxes();
        take_out();
        boxes_->refine(halve);
    }

    bool queue_rest() override {
        if (boxes_) return boxes_->queue_rest();
        if (round_.report[OVERFLOW_WORD] == 0) return false;
        round_.reset(OVERFLOW_WORD);
        grow(2 * round_.geometry.capacity);
        cut_spans();
        return true;
    }

    void download() override {
        if (boxes_) return boxes_->download();
        free_lengths_ = round_.download_results(round_.plan.lines);
    }

    void end_round() override {
        if (boxes_) boxes_->end_round();
    }

    std::span<const std::uint32_t> free_lengths() const override {
        return boxes_ ? boxes_->free_lengths() : free_lengths_;
    }
    std::uint32_t width() const override {
        return boxes_ ? boxes_->width() : round_.plan.strip_width;
    }

    void snapshot(Snapshot& snapshot) override {
        if (round_.plan.is_exact()) grid_.snapshot(snapshot);
        if (boxes_) {
            snapshot.box_width = boxes_->width();
            snapshot.boxes = boxes_->get();
            return;
        }
        std::vector<std::uint32_t> counts(all_tiles());
        round_.get<std::uint32_t>(round_.memory.span_counts, counts);
        for (std::size_t i = 0; i < slabs_.size(); ++i) {
            std::vector<Span> slots(std::size_t{slabs_[i].lines()} * tiles_.count *
                                    round_.geometry.capacity);
            round_.get<Span>(spans_[i], slots);
            round_.queue.wait();
            unpack(slabs_[i], tiles_, slots, counts, snapshot);
        }
    }

    void restore(const Snapshot& snapshot) override {
        grid_.restore(snapshot);
        boxes_.reset();
        slabs_.clear();
        spans_.clear();
        if (snapshot.box_width == 0) return put_spans(snapshot);
        boxes_.emplace(round_, snapshot.box_width);
        boxes_->put(snapshot.boxes);
    }

private:
    // The most samples of a round near a tile of a column; grows with the room for spans.
    std::uint32_t near_room() const { return kSamplesNearSpan * round_.geometry.capacity; }

    RoundMemory::Listing listing() const { return {.words_of_bin = 1, .bins = round_.plan.lines}; }

    // The number of tiles of all lines together.
    std::uint32_t all_tiles() const { return round_.plan.lines * tiles_.count; }

    // At the first refinement: counts the boxes of each tile and, once there is room, writes them.
    void turn_into_boxes() {
        make_room_to_scan(round_, all_tiles());
        round_.make_room(round_.memory.boxes, 0);
        unfold(true);
        scan(round_.queue, round_.memory, all_tiles());
        round_.start_download();
        round_.queue.wait();
        round_.throw_if_failed();
        boxes_.emplace(round_, round_.plan.strip_width);
        boxes_->make_room(round_.report[TOTAL_WORD]);
        unfold(false);
        slabs_.clear();
        spans_.clear();
    }

    void unfold(bool is_counting) {
        for (std::size_t i = 0; i < slabs_.size(); ++i) {
            portable::SlabArguments arguments = arguments_of(i);
            if (!is_counting) arguments.block_bits = block_bits_of_scan(all_tiles());
            launch_over_tiles<kernels::unfold>(i, arguments, kTileWork);
        }
    }

    void put_spans(const Snapshot& snapshot) {
        make_slabs(snapshot.capacity);
        std::uint64_t tile = 0;
        for (std::size_t i = 0; i < slabs_.size(); ++i) {
            const Packed packed = pack(slabs_[i], tiles_, snapshot);
            round_.put<Span>(spans_[i], packed.slots);
            round_.put<std::uint32_t>(round_.memory.span_counts, packed.counts, tile);
            round_.put<std::uint32_t>(round_.memory.tile_lengths, packed.lengths, tile);
            round_.queue.wait();
            tile += packed.counts.size();
        }
        sum_tiles();
        first_lengths_.assign(round_.plan.lines, 0);
        for (std::uint32_t line = 0; line < round_.plan.lines; ++line)
            for (const Span span : snapshot.spans[line])
                first_lengths_[line] += span.end - span.begin;
        free_lengths_ = first_lengths_;
    }

    void make_slabs(std::uint32_t capacity) {
        round_.geometry.capacity = capacity;
        slabs_ = share_out(round_.plan.lines, capacity * tiles_.count, largest_slab_);
        spans_.assign(slabs_.size(), {});
        const std::uint64_t lists = std::uint64_t{round_.geometry.columns} * tiles_.count;
        round_.make_room(round_.memory.near, 2 * lists * near_room());
        round_.make_room(round_.memory.near_counts, lists);
        for (std::size_t i = 0; i < slabs_.size(); ++i)
            round_.make_room(spans_[i],
                             2 * std::uint64_t{slabs_[i].lines()} * tiles_.count * capacity);
    }

    // Makes room for `larger` spans a tile, and keeps the spans.
    void grow(std::uint32_t larger) {
        const std::vector<Slab> old_slabs = std::move(slabs_);
        const std::vector<Buffer> old_spans = std::move(spans_);
        portable::SlabArguments arguments{.g = round_.geometry, .larger = larger};
        make_slabs(larger);
        Memory memory = round_.memory;
        for (std::size_t from = 0; from < old_slabs.size(); ++from) {
            for (std::size_t to = 0; to < slabs_.size(); ++to) {
                const auto& [old_first, old_end] = old_slabs[from];
                const auto& [first, end] = slabs_[to];
                arguments.slab_begin = old_first * tiles_.count;
                arguments.to_begin = first * tiles_.count;
                arguments.first_tile = std::max(old_first, first) * tiles_.count;
                arguments.end_tile = std::min(old_end, end) * tiles_.count;
                if (arguments.first_tile >= arguments.end_tile) continue;
                memory.spans = old_spans[from];
                memory.new_spans = spans_[to];
                launch<kernels::grow>(round_.queue, memory, arguments,
                                      arguments.end_tile - arguments.first_tile, kTileWork);
            }
        }
    }

    void cut_spans() {
        launch<kernels::collect>(round_.queue, round_.memory, arguments_of(0),
                                 std::uint64_t{round_.geometry.columns} * tiles_.count,
                                 kSubtractWork);
        const Span own = round_.plan.own_lines();
        for (std::size_t i = 0; i < slabs_.size(); ++i) {
            portable::SlabArguments arguments = arguments_of(i);
            arguments.first_tile = std::max(arguments.first_tile, own.begin * tiles_.count);
            arguments.end_tile = std::min(arguments.end_tile, own.end * tiles_.count);
            if (arguments.first_tile < arguments.end_tile)
                launch_over_tiles<kernels::subtract>(i, arguments, kSubtractWork);
        }
        sum_tiles();
    }

    void sum_tiles() {
        launch<kernels::sum_tiles>(round_.queue, round_.memory,
                                   {.g = round_.geometry, .tiles = tiles_.count}, round_.plan.lines,
                                   kTileWork);
    }

    template <typename Kernel>
    void launch_over_tiles(std::size_t slab, const portable::SlabArguments& arguments,
                           std::uint64_t work) {
        launch<Kernel>(round_.queue, memory_of(slab), arguments,
                       arguments.end_tile - arguments.first_tile, work);
    }

    Memory memory_of(std::size_t slab) const {
        Memory memory = round_.memory;
        memory.spans = spans_[slab];
        return memory;
    }
    portable::SlabArguments arguments_of(std::size_t slab) const {
        return {.g = round_.geometry,
                .first_tile = slabs_[slab].first_line * tiles_.count,
                .end_tile = slabs_[slab].end_line * tiles_.count,
                .slab_begin = slabs_[slab].first_line * tiles_.count,
                .near_room = near_room(),
                .last_pass = kPasses - 1,
                .tiles = tiles_.count,
                .tile_height = tiles_.height};
    }

    const Tiles tiles_;
    std::uint64_t largest_slab_;
    std::vector<std::uint32_t> first_lines_;
    Grid grid_;
    std::optional<GridBoxes> boxes_;  // from the first refinement on, in place of spans
    std::vector<Slab> slabs_;
    std::vector<Buffer> spans_;                    // of each slab; freed at the first refinement
    std::span<const std::uint32_t> free_lengths_;  // of the lines
    std::vector<std::uint32_t> first_lengths_;     // of lines that no kernel has cut
};

}  // namespace

std::unique_ptr<Bins> make_spans(RoundMemory& round, const Tuning& tuning) {
    return std::make_unique<Spans>(round, tuning);
}

}  // namespace lacuna::device
