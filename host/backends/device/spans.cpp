// The bins of modes lines and exact on a device: the free spans of lines, in slabs, until exact
// refines them into boxes.
#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "backends/columns.h"
#include "backends/device/bins.h"
#include "backends/device/boxes.h"
#include "backends/device/grid.h"
#include "backends/device/scan.h"
#include "plan/first_free.h"

namespace lacuna::device {
namespace {

// See Queue::launch.
constexpr std::uint64_t kLocateWork = 4;
constexpr std::uint64_t kGrowWork = 2;

class Spans : public Bins {
public:
    Spans(RoundMemory& round, const Tuning& tuning)
        : Bins(round),
          largest_slab_(tuning.largest_slab_bytes != 0 ? tuning.largest_slab_bytes
                                                       : round.queue.device().largest_buffer_bytes),
          first_lines_(first_lines(round.plan, round.geometry.columns)) {
        const Plan& plan = round_.plan;
        Memory& m = round_.memory;
        round_.make_room(m.span_counts, plan.lines);
        round_.make_room(m.free_lengths, plan.lines);
        round_.make_room(m.near_begins, round_.geometry.columns + std::uint64_t{1});
        round_.make_room(m.near_counts, round_.geometry.columns);
        round_.make_room(m.overflow, 1);
        round_.queue.fill(m.overflow, 0, 1);
        if (plan.is_exact()) grid_.emplace(round_);
        make_lines();
    }

    std::span<const std::uint32_t> begins() const override {
        return boxes_ ? boxes_->begins() : first_lines_;
    }

    void begin_part() override {
        find_near_begins(round_.plan, round_.geometry.columns, round_.column_begins, near_begins_);
        round_.make_room(round_.memory.near, 2 * std::uint64_t{near_begins_.back()});
        round_.put<std::uint32_t>(round_.memory.near_begins, near_begins_);
    }

    void locate(std::span<const Draw> draws) override {
        if (boxes_)
            return round_.launch_over_draws<kernels::locate_in_boxes>(round_.arguments(), 1);
        const std::uint32_t chunk = chunk_of_lines();
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

    void screen(Range draws, std::uint32_t status) override {
        if (grid_) return grid_->screen(draws, status);
        const std::uint32_t chunk = chunk_of_lines();
        for (std::size_t i = 0; i < slabs_.size(); ++i) {
            portable::SlabArguments arguments = arguments_of(i);
            arguments.chunk = chunk;
            arguments.first_draw = draws.begin;
            arguments.end_draw = draws.end;
            launch<kernels::screen_on_lines>(round_.queue, memory_of(i), arguments,
                                             items_of(draws.end - draws.begin, chunk),
                                             kLocateWork * chunk);
        }
    }

    void admit(std::uint32_t pass) override {
        round_.admit<kernels::admit>(round_.arguments(), pass,
                                     round_.queue.run_of(round_.part_count()));
    }

    void subtract() override {
        if (grid_) grid_->insert();
        cut_spans();
    }

    void take_out() override {
        if (grid_) return grid_->insert();
        cut_spans();
    }
    bool is_cut_by_take_out() const override { return !grid_; }

    void refine(bool halve) override {
        if (!grid_) throw std::logic_error("mode lines has nothing to refine");
        if (!boxes_) turn_into_boxes();
        grid_->insert();
        boxes_->refine(halve);
    }

    void start_download() override {
        if (boxes_) return boxes_->start_download();
        free_lengths_.resize(round_.plan.lines);
        round_.get<std::uint32_t>(round_.memory.free_lengths, free_lengths_);
        round_.get<std::uint32_t>(round_.memory.overflow, overflow_);
    }

    bool queue_rest() override {
        if (boxes_) return boxes_->queue_rest();
        if (overflow_.front() == 0) return false;
        grow(2 * round_.geometry.capacity);
        cut_spans();
        return true;
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
        if (grid_) grid_->snapshot(snapshot);
        if (boxes_) {
            snapshot.box_width = boxes_->width();
            snapshot.boxes = boxes_->get();
            return;
        }
        std::vector<std::uint32_t> counts(round_.plan.lines);
        round_.get<std::uint32_t>(round_.memory.span_counts, counts);
        for (std::size_t i = 0; i < slabs_.size(); ++i) {
            std::vector<Span> slots(std::size_t{slabs_[i].lines()} * round_.geometry.capacity);
            round_.get<Span>(spans_[i], slots);
            round_.queue.wait();
            unpack(slabs_[i], slots, counts, snapshot);
        }
    }

    void restore(const Snapshot& snapshot) override {
        if (grid_) grid_->restore(snapshot);
        boxes_.reset();
        slabs_.clear();
        spans_.clear();
        if (snapshot.box_width == 0) return put_spans(snapshot);
        boxes_.emplace(round_, snapshot.box_width);
        boxes_->put(snapshot.boxes, {});
    }

private:
    // The number of draws that one item serves; each may walk along a whole line.
    std::uint32_t chunk_of_lines() const {
        const std::uint32_t run = round_.queue.run_of(round_.part_count());
        if (!round_.queue.runs_in_lockstep()) return run;
        return std::clamp(kMostTurns / round_.geometry.capacity, 1u, run);
    }

    // At the first refinement: counts the boxes of each line and, once there is room, writes them.
    void turn_into_boxes() {
        std::array<std::uint32_t, 1> total{};
        make_room_to_scan(round_, round_.plan.lines);
        round_.make_room(round_.memory.boxes, 0);
        unfold(true);
        scan(round_.queue, round_.memory, round_.plan.lines);
        round_.get<std::uint32_t>(round_.memory.total, total);
        round_.start_download(false);
        round_.queue.wait();
        round_.throw_if_failed();
        boxes_.emplace(round_, round_.plan.strip_width);
        boxes_->make_room(total.front());
        unfold(false);
        slabs_.clear();
        spans_.clear();
    }

    void unfold(bool is_counting) {
        for (std::size_t i = 0; i < slabs_.size(); ++i) {
            portable::SlabArguments arguments = arguments_of(i);
            arguments.block_bits = block_bits_of_scan(round_.plan.lines);
            arguments.is_counting = is_counting ? 1 : 0;
            launch<kernels::unfold>(round_.queue, memory_of(i), arguments, slabs_[i].lines(),
                                    round_.geometry.capacity / (is_counting ? 8 : 4));
        }
    }

    // Uploads the lines' first spans, packed, and then spreads them out.
    void make_lines() {
        Snapshot first;
        first.capacity = 1;
        for (std::uint32_t line = 0; line < round_.plan.lines; ++line) {
            first.spans.push_back(first_spans(round_.plan, line));
            const auto count = static_cast<std::uint32_t>(first.spans.back().size());
            first.capacity = std::max(first.capacity, count);
        }
        put_spans(first);
        grow(std::max(first_capacity(round_.plan), first.capacity));
        round_.queue.wait();
    }

    void put_spans(const Snapshot& snapshot) {
        make_slabs(snapshot.capacity);
        for (std::size_t i = 0; i < slabs_.size(); ++i) {
            const std::vector<Span> slots = pack(slabs_[i], snapshot);
            round_.put<Span>(spans_[i], slots);
            round_.queue.wait();
        }
        std::vector<std::uint32_t> counts, lengths;
        for (const std::vector<Span>& of_line : snapshot.spans) {
            counts.push_back(static_cast<std::uint32_t>(of_line.size()));
            lengths.push_back(0);
            for (const Span span : of_line) lengths.back() += span.end - span.begin;
        }
        round_.put<std::uint32_t>(round_.memory.span_counts, counts);
        round_.put<std::uint32_t>(round_.memory.free_lengths, lengths);
        round_.queue.wait();
    }

    void make_slabs(std::uint32_t capacity) {
        round_.geometry.capacity = capacity;
        slabs_ = share_out(round_.plan.lines, capacity, largest_slab_);
        spans_.assign(slabs_.size(), {});
        for (std::size_t i = 0; i < slabs_.size(); ++i)
            round_.make_room(spans_[i], 2 * std::uint64_t{slabs_[i].lines()} * capacity);
    }

    // Makes room for `larger` spans a line, and keeps the spans.
    void grow(std::uint32_t larger) {
        const std::vector<Slab> old_slabs = std::move(slabs_);
        const std::vector<Buffer> old_spans = std::move(spans_);
        portable::SlabArguments arguments{.g = round_.geometry, .larger = larger};
        make_slabs(larger);
        Memory memory = round_.memory;
        for (std::size_t from = 0; from < old_slabs.size(); ++from) {
            for (std::size_t to = 0; to < slabs_.size(); ++to) {
                arguments.slab_begin = old_slabs[from].first_line;
                arguments.to_begin = slabs_[to].first_line;
                arguments.first_line = std::max(arguments.slab_begin, arguments.to_begin);
                arguments.end_line = std::min(old_slabs[from].end_line, slabs_[to].end_line);
                if (arguments.first_line >= arguments.end_line) continue;
                memory.spans = old_spans[from];
                memory.new_spans = spans_[to];
                launch<kernels::grow>(round_.queue, memory, arguments,
                                      arguments.end_line - arguments.first_line, kGrowWork);
            }
        }
    }

    void cut_spans() {
        const std::uint32_t columns = round_.geometry.columns;
        const std::uint64_t near = 3 * std::uint64_t{round_.draws_per_column()};
        round_.queue.fill(round_.memory.overflow, 0, 1);
        launch<kernels::collect>(round_.queue, round_.memory,
                                 {.last_pass = kPasses - 1, .g = round_.geometry}, columns, near);
        const Span own = round_.plan.own_lines();
        for (std::size_t i = 0; i < slabs_.size(); ++i) {
            portable::SlabArguments arguments = arguments_of(i);
            arguments.first_line = std::max(arguments.first_line, own.begin);
            arguments.end_line = std::min(arguments.end_line, own.end);
            if (arguments.first_line < arguments.end_line)
                launch<kernels::subtract>(round_.queue, memory_of(i), arguments,
                                          arguments.end_line - arguments.first_line, near);
        }
    }

    Memory memory_of(std::size_t slab) const {
        Memory memory = round_.memory;
        memory.spans = spans_[slab];
        return memory;
    }
    portable::SlabArguments arguments_of(std::size_t slab) const {
        return {.chunk = 1,
                .g = round_.geometry,
                .first_line = slabs_[slab].first_line,
                .end_line = slabs_[slab].end_line,
                .slab_begin = slabs_[slab].first_line,
                .last_pass = kPasses - 1};
    }

    std::uint64_t largest_slab_;
    std::vector<std::uint32_t> first_lines_;
    std::optional<Grid> grid_;    // in exact
    std::optional<Boxes> boxes_;  // from the first refinement on, in place of spans
    std::vector<Slab> slabs_;
    std::vector<Buffer> spans_;  // of each slab; freed at the first refinement
    std::vector<std::uint32_t> near_begins_;
    std::vector<std::uint32_t> free_lengths_;
    std::array<std::uint32_t, 1> overflow_{};
};

}  // namespace

std::unique_ptr<Bins> make_spans(RoundMemory& round, const Tuning& tuning) {
    return std::make_unique<Spans>(round, tuning);
}

}  // namespace lacuna::device
