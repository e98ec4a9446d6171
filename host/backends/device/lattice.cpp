// The bins of mode cells: lines of the lattice's bits, and the radius map for subtract.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "backends/columns.h"
#include "backends/device/bins.h"
#include "backends/device/cells_layout.h"
#include "plan/first_free.h"
#include "portable/status.h"

namespace lacuna::device {
namespace {

// The most turns of a slice of subtract, as cells_layout.h counts them. A counted turn costs up to
// 9 real ones: lavapipe runs the loops of square roots even where none is needed, a run of points
// ends with its word of bits, and on a torus a sample is seen from three heights. Looking at a line
// takes up to 64 more.
constexpr std::uint64_t kMostTurnsOfSlice = kMostTurns / 4;
// The least number of slices: then items in lockstep, as on lavapipe, serve neighbouring lines.
constexpr std::uint32_t kLeastSlices = 16;
// Candidates of one item of subtract: few, because a sample is much more work than a draw.
constexpr std::uint32_t kLongestChunk = 64;

// Words of bits, and turns of loops, in a unit of work: see Queue::launch.
constexpr std::uint64_t kWordsPerWork = 32;
constexpr std::uint64_t kTurnsPerWork = 8;

constexpr std::uint32_t kPartWords = 1 << 20;  // in one upload of bits

class Lattice : public Bins {
public:
    Lattice(RoundMemory& round, const Tuning& tuning)
        : Bins(round),
          first_lines_(first_lines(round.plan, round.geometry.columns)),
          words_(words_per_line(round.plan)),
          serves_chunks_(!round.queue.runs_in_lockstep()),
          free_lengths_(first_free_lengths(round.plan)) {
        const Plan& plan = round_.plan;
        const RadiusMap& map = *plan.cells().radii;
        Memory& m = round_.memory;
        m.free_lengths = round_.copy_of(free_lengths_);
        m.pixel_radii = round_.copy_of(map.radii);
        m.pixel_reaches = round_.copy_of(map.reaches);
        m.widest_rows = round_.copy_of(map.widest_rows);
        m.column_of = round_.copy_of(map.column_of);
        m.row_of = round_.copy_of(map.row_of);
        m.row_begins = round_.copy_of(map.row_begins);
        round_.geometry.capacity = words_;
        round_.make_room(m.bits, std::uint64_t{plan.lines} * words_);
        round_.make_room(m.widest, plan.lines);
        round_.queue.fill(m.widest, 0, plan.lines);
        upload_first_bits();
        find_reaches(tuning);
    }

    std::span<const std::uint32_t> sorted_columns() const override { return first_lines_; }

    PartLimits part_limits(std::uint32_t count) const override {
        PartLimits limits = limits_by_area(count, mean_disk_area_, share_);
        limits.of_column = kMostOfColumn;
        return limits;
    }

    void begin_part() override {
        Memory& m = round_.memory;
        for (Buffer* const one : {&m.candidate_radii, &m.todo, &m.left})
            round_.make_room(*one, round_.draw_count);
    }

    void locate(std::span<const Draw>) override {
        const std::uint32_t chunk = chunk_of(words_);  // a draw may walk the whole line
        launch<kernels::locate_in_cells>(round_.queue, round_.memory,
                                         {.chunk = chunk,
                                          .g = round_.geometry,
                                          .first_draw = round_.part.begin,
                                          .end_draw = round_.part.end},
                                         items_of(round_.part_count(), chunk),
                                         chunk * (words_ / kWordsPerWork + 1));
    }

    void sort() override {
        round_.sort();
        round_.launch_over_draws<kernels::look_up_radii>(arguments_of(), 1);
    }

    void screen(Range draws, std::uint32_t status, bool) override {
        if (status != STATUS_UNDECIDED) round_.screen<kernels::screen_in_cells>(draws, status, 1);
    }

    void admit(std::uint32_t pass) override {
        // A candidate looks at all columns within its reach, and at their candidates.
        constexpr double kTurnsOfColumn = 4;
        const double near = kTurnsOfColumn * share_of_lines_ * round_.geometry.columns +
                            share_ * round_.part_count();
        round_.admit<kernels::admit_in_cells>(arguments_of(), pass,
                                              chunk_of(static_cast<std::uint64_t>(near) + 16));
    }

    void subtract() override {
        take_out();
        round_.make_room_for_listing({});
        round_.count_samples({});
        round_.list_samples({});
    }

    void take_out() override {
        served_reach_ = short_reach_;
        queue_cuts(round_.part_count(), false, mean_reach_);
    }

    void refine(bool) override { throw std::logic_error("mode cells has nothing to refine"); }

    // Samples of longer reach are served by further launches, each for twice the reach of the last.
    bool queue_rest() override {
        const std::uint32_t left = round_.report[LEFT_WORD];
        if (left == 0) return false;
        round_.reset(LEFT_WORD);
        std::swap(round_.memory.todo, round_.memory.left);
        served_reach_ = std::min(2 * served_reach_, widest_);
        queue_cuts(left, true, served_reach_);
        return true;
    }

    void download() override {
        round_.get<std::uint32_t>(round_.memory.free_lengths, free_lengths_);
        round_.download_results(0);
    }

    std::span<const std::uint32_t> free_lengths() const override { return free_lengths_; }
    std::uint32_t width() const override { return 1; }

    void put_candidates(std::vector<Candidate>& candidates) override {
        round_.put<Candidate>(round_.memory.located, candidates);
        round_.queue.wait();
    }

    void snapshot(Snapshot& snapshot) override {
        snapshot.bits.resize(std::size_t{round_.plan.lines} * words_);
        round_.get<std::uint32_t>(round_.memory.bits, snapshot.bits);
        round_.queue.wait();
    }

    void restore(const Snapshot& snapshot) override {
        std::vector<std::uint32_t> lengths(round_.plan.lines, 0);
        for (std::size_t i = 0; i < snapshot.bits.size(); ++i)
            lengths[i / words_] += static_cast<std::uint32_t>(std::popcount(snapshot.bits[i]));
        round_.put<std::uint32_t>(round_.memory.bits, snapshot.bits);
        round_.put<std::uint32_t>(round_.memory.free_lengths, lengths);
        free_lengths_ = lengths;
        round_.queue.fill(round_.memory.widest, 0, round_.plan.lines);
        round_.queue.wait();
    }

private:
    // Uploads some lines at a time: a lattice may fill most of the device's memory.
    void upload_first_bits() {
        const std::uint32_t lines = round_.plan.lines;
        const std::uint32_t step = std::max(kPartWords / words_, 1u);
        for (std::uint32_t line = 0; line < lines; line += step) {
            const std::uint32_t end = line + std::min(step, lines - line);
            const std::vector<std::uint32_t> bits = first_bits(round_.plan, line, end);
            round_.put<std::uint32_t>(round_.memory.bits, bits, std::uint64_t{line} * words_);
            round_.queue.wait();
        }
    }

    // On a processor, which runs items one by one, an item serves whole samples. Elsewhere an item
    // serves a slice of the lines near a sample. Samples whose reach needs more than the least
    // number of slices are left for later launches.
    void find_reaches(const Tuning& tuning) {
        const RadiusMap& map = *round_.plan.cells().radii;
        widest_ = *std::max_element(map.reaches.begin(), map.reaches.end());
        if (serves_chunks_) fixed_slices_ = std::max(tuning.slices_of_sample, 1u);
        short_reach_ = fixed_slices_ != 0 ? widest_ : 1;
        while (short_reach_ < widest_ && slices_of(short_reach_ + 1) == kLeastSlices)
            ++short_reach_;

        const double side = 2.0 * widest_ + 1;
        share_of_lines_ = std::min(side / round_.plan.lines, 1.0);
        share_ = share_of_lines_ * std::min(side / round_.plan.height, 1.0);
        find_mean_disk_area();

        // The mean reach of a sample, where samples have a density of 1 / reach^2.
        double density = 0;
        double pixels = 0;
        for (const std::uint32_t reach : map.reaches) {
            if (reach == 0) continue;
            density += 1 / (static_cast<double>(reach) * reach);
            ++pixels;
        }
        mean_reach_ =
            std::min(static_cast<std::uint32_t>(std::sqrt(pixels / density)), short_reach_);
    }

    // The fraction of the lattice within the radius of a pixel with importance, on average.
    void find_mean_disk_area() {
        constexpr double kUnitsPerStep = 256;
        double sum = 0;
        std::size_t open = 0;
        for (const std::uint32_t radius : round_.plan.cells().radii->radii) {
            if (radius == 0) continue;
            const double side = 2 * radius / kUnitsPerStep + 1;
            sum +=
                std::min(side / round_.plan.lines, 1.0) * std::min(side / round_.plan.height, 1.0);
            ++open;
        }
        mean_disk_area_ = sum / static_cast<double>(open);
    }

    // The number of slices that divide the lines near a sample with this reach.
    std::uint32_t slices_of(std::uint32_t reach) const {
        if (fixed_slices_ != 0) return fixed_slices_;
        return std::max(kLeastSlices, slices_of_sample(round_.plan, reach, kMostTurnsOfSlice));
    }

    // The number of draws that one item serves if each takes this many turns.
    std::uint32_t chunk_of(std::uint64_t turns) const {
        const std::uint32_t chunk = round_.queue.run_of(round_.part_count());
        if (serves_chunks_) return chunk;
        return static_cast<std::uint32_t>(std::clamp<std::uint64_t>(kMostTurns / turns, 1, chunk));
    }

    portable::DrawArguments arguments_of() const {
        portable::DrawArguments arguments = round_.arguments();
        arguments.rows = round_.plan.cells().radii->rows;
        arguments.metric = static_cast<std::uint32_t>(round_.plan.cells().metric);
        return arguments;
    }

    void queue_cuts(std::uint32_t count, bool is_listed, std::uint32_t usual_reach) {
        const std::uint32_t chunk = std::min(round_.queue.chunk_of(count), kLongestChunk);
        const std::uint64_t items = items_of(count, chunk);
        // Fewer slices if the number of items in all slices would not fit into 31 bits.
        const std::uint64_t most = std::numeric_limits<std::uint32_t>::max() / 2;
        const auto slices = static_cast<std::uint32_t>(std::min<std::uint64_t>(
            slices_of(served_reach_),
            std::max<std::uint64_t>(most / std::max<std::uint64_t>(items, 1), 1)));
        const std::uint64_t turns = turns_of_sample(round_.plan, usual_reach) / slices;
        portable::DrawArguments arguments = arguments_of();
        arguments.chunk = chunk;
        if (is_listed) arguments.first = 0;
        arguments.count = arguments.first + count;
        arguments.slices = slices;
        arguments.most_reach = served_reach_;
        arguments.is_listed = is_listed ? 1 : 0;
        launch<kernels::subtract_in_cells>(round_.queue, round_.memory, arguments, items * slices,
                                           chunk * (turns / kTurnsPerWork + 1));
    }

    std::vector<std::uint32_t> first_lines_;
    std::uint32_t words_;  // of a line
    bool serves_chunks_;
    std::vector<std::uint32_t> free_lengths_;

    std::uint32_t widest_ = 0;       // the longest reach
    std::uint32_t short_reach_ = 0;  // the longest reach that needs only the fewest slices
    std::uint32_t mean_reach_ = 0;
    std::uint32_t served_reach_ = 0;  // the longest reach served
    std::uint32_t fixed_slices_ = 0;
    double share_of_lines_ = 0;  // of the lattice's lines, within widest_
    double share_ = 0;
    double mean_disk_area_ = 0;
};

}  // namespace

std::unique_ptr<Bins> make_lattice(RoundMemory& round, const Tuning& tuning) {
    return std::make_unique<Lattice>(round, tuning);
}

}  // namespace lacuna::device
