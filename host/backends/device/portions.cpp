// The bins of surfaces and volumes on a device: parts of triangles or boxes, which are split until
// the balls of samples cover them (docs/space.md). Samples are in lists, one for each block of
// bins.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "backends/device/bins.h"
#include "backends/device/boxes.h"
#include "plan/first_free.h"
#include "portable/status.h"
#include "space/portion.h"

namespace lacuna::device {
namespace {

using portable::Corner;
using portable::Listed;
using portable::Portion;
using space::FirstBins;

// The work of a draw and of a bin, see Queue::launch.
constexpr std::uint64_t kLocateInSpaceWork = 2;
constexpr std::uint64_t kScreenInSpaceWork = 8;
constexpr std::uint64_t kSplitInSpaceWork = 16;
constexpr std::uint64_t kKeepInSpaceWork = 4;

// The bins, without the samples.
class Portions final : public Boxes {
public:
    explicit Portions(RoundMemory& round)
        : Boxes(round, {.strip_bits = 1,
                        .words_of_bin = 2,
                        .own = {0, std::numeric_limits<std::uint32_t>::max()},
                        .boxes = &Memory::portions,
                        .new_boxes = &Memory::new_portions}) {
        const FirstBins& all = *round.plan.space().first_bins;
        std::vector<std::uint32_t> blocks;
        for (std::uint32_t block = 0; block < all.blocks(); ++block)
            blocks.resize(all.begins[block + 1], block);
        round.put_in_room<std::uint32_t>(round.memory.blocks, blocks);
        FirstFree free(round.plan);
        free.lengths.insert(free.lengths.end(), free.widths.begin(), free.widths.end());
        put<Portion>(all.bins, std::move(free.lengths));
        add_up();
    }

    std::span<const std::uint32_t> widths() const { return sizes_.subspan(count_, count_); }
    std::uint64_t weight_of(std::size_t bin) const {
        return std::uint64_t{free_lengths()[bin]} * widths()[bin];
    }
    std::uint64_t total() const { return total_; }

    void end_round() override {
        std::swap(round_.memory.blocks, round_.memory.new_blocks);
        Boxes::end_round();
        add_up();
    }

private:
    void add_up() {
        total_ = 0;
        for (std::size_t bin = 0; bin < count_; ++bin) total_ += weight_of(bin);
    }

    // Asks for all the room that buffers have, so that rounds are rarely repeated with larger ones.
    std::uint32_t more_boxes(bool halve) const override {
        const std::uint64_t room = room_for_boxes(round_.plan);
        const std::uint64_t more = room > count_ ? room - count_ : 0;
        return halve ? static_cast<std::uint32_t>(std::max<std::uint64_t>(more, count_)) : 0;
    }
    void make_room_to_cut(std::uint64_t boxes, bool) override {
        round_.make_room(round_.memory.kept_pieces, boxes);
    }
    void make_room_to_keep(std::uint64_t room) override {
        round_.make_room(round_.memory.new_blocks, room);
    }
    void queue_cut(bool) override {
        launch_over_boxes<kernels::split_in_space>(count_, round_.queue.chunk_of(count_),
                                                   kSplitInSpaceWork);
    }
    void queue_keep() override {
        launch_over_boxes<kernels::keep_in_space>(count_, round_.queue.chunk_of(count_),
                                                  kKeepInSpaceWork);
    }
    void list_samples(RoundMemory::Listing listing) override {
        round_.list_samples<kernels::list_samples_in_space>(listing);
    }
    std::uint64_t least_to_split() const override {
        return space::least_weight_to_split(total_, count_);
    }

    std::uint64_t total_ = 0;  // weight of all bins
};

class BinsInSpace : public Bins {
public:
    explicit BinsInSpace(RoundMemory& round)
        : Bins(round), all_(*round.plan.space().first_bins), portions_(round) {
        put_tables();
        put_kept();
        find_shares();
        next_draw_ = round.plan.first_draw;
    }

    PartLimits part_limits(std::uint32_t count) const override {
        // A ball holds about a sixth of the weight of the blocks around its middle.
        return limits_by_area(count, mean_share_ / 6, widest_share_);
    }

    void begin_round() override {
        Memory& m = round_.memory;
        const std::uint64_t draws = round_.draw_count;
        for (Buffer* const of_draws : {&m.heights, &m.next_candidates, &m.third_bits})
            round_.make_room(*of_draws, draws);
        round_.grow(m.listed, 4 * std::uint64_t{samples_}, 4 * (samples_ + draws));
        first_draw_ = std::exchange(next_draw_, next_draw_ + draws);
    }

    void locate(std::span<const Draw> draws) override {
        if (all_.is_volume()) {
            third_bits_.clear();
            for (const Draw& draw : draws)
                third_bits_.push_back(space::third_bits(round_.plan, first_draw_ + draw.order));
            round_.put<std::uint32_t>(round_.memory.third_bits, third_bits_, round_.part.begin);
        }
        round_.launch_over_draws<kernels::locate_in_space>(round_.arguments(), kLocateInSpaceWork);
    }

    void screen(Range draws, std::uint32_t status, bool opens) override {
        round_.screen<kernels::screen_in_space>(draws, status, kScreenInSpaceWork, opens);
    }

    void admit(std::uint32_t pass) override {
        const portable::DrawArguments arguments = round_.arguments();
        round_.admit<kernels::admit_in_space>(arguments, pass, arguments.chunk);
    }

    void subtract() override { refine(false); }
    void take_out() override {
        portable::DrawArguments arguments = round_.arguments();
        arguments.room = samples_;
        round_.launch_over_draws<kernels::insert_in_space>(arguments, 1);
    }
    void refine(bool halve) override {
        take_out();
        portions_.refine(halve);
    }

    bool queue_rest() override { return portions_.queue_rest(); }
    void download() override { portions_.download(); }
    void end_round() override {
        portions_.end_round();
        samples_ += round_.report[ENTRIES_WORD];
    }

    std::span<const std::uint32_t> free_lengths() const override {
        return portions_.free_lengths();
    }
    std::uint32_t width() const override { return 0; }
    std::span<const std::uint32_t> widths() const override { return portions_.widths(); }

    void snapshot(Snapshot&) override { throw std::logic_error("in space there are no snapshots"); }
    void restore(const Snapshot&) override {
        throw std::logic_error("in space there are no snapshots");
    }

private:
    void put_tables() {
        Memory& m = round_.memory;
        std::vector<Corner> corners;
        for (std::size_t i = 0; i < all_.triangles.size(); ++i) {
            const auto& [a, b, c] = all_.triangles[i];
            const std::uint64_t weight = all_.weights[i];
            corners.push_back({a.x, a.y, a.z, static_cast<std::uint32_t>(weight)});
            corners.push_back({b.x, b.y, b.z, static_cast<std::uint32_t>(weight >> 32U)});
            corners.push_back({c.x, c.y, c.z, 0});
        }
        round_.put_in_room<Corner>(m.corners, corners);
        round_.put_in_room<std::uint32_t>(m.near_blocks, all_.near);
        round_.put_in_room<std::uint32_t>(m.near_begins, all_.near_begins);
        std::vector<std::uint32_t> volume(7);
        for (std::size_t axis = 0; axis < 3 && all_.is_volume(); ++axis) {
            volume[axis] = static_cast<std::uint32_t>(all_.sides[axis]);
            volume[3 + axis] = all_.cells[axis];
        }
        volume[6] = all_.wraps ? 1 : 0;
        round_.put_in_room<std::uint32_t>(m.volume, volume);
    }

    void put_kept() {
        Memory& m = round_.memory;
        std::vector<Listed> listed;
        std::vector<std::uint32_t> heads(all_.blocks(), NO_SAMPLE);
        for (std::size_t block = 0; block < all_.blocks(); ++block)
            for (std::uint32_t i = all_.kept_begins[block]; i < all_.kept_begins[block + 1]; ++i) {
                const space::Position& at = all_.kept[i];
                listed.push_back({at.x, at.y, at.z, std::exchange(heads[block], i)});
            }
        samples_ = static_cast<std::uint32_t>(listed.size());
        round_.make_room(m.listed, 4 * (samples_ + room_for_entries(round_.plan)));
        round_.put_in_room<Listed>(m.listed, listed);
        round_.put_in_room<std::uint32_t>(m.sample_heads, heads);
        round_.make_room(m.cell_heads, all_.blocks());
        round_.queue.fill(m.cell_heads, NO_SAMPLE, all_.blocks());
        round_.queue.wait();
    }

    // The share of the first draws that fall into the blocks around a block.
    void find_shares() {
        std::vector<double> shares(all_.blocks());
        for (std::uint32_t block = 0; block < all_.blocks(); ++block)
            for (std::uint32_t i = all_.begins[block]; i < all_.begins[block + 1]; ++i)
                shares[block] += static_cast<double>(portions_.weight_of(i)) /
                                 static_cast<double>(portions_.total());
        for (std::uint32_t block = 0; block < all_.blocks(); ++block) {
            double around = 0;
            all_.for_each_near(block, [&](std::uint32_t other, const space::Position&) {
                around += shares[other];
            });
            mean_share_ += shares[block] * std::min(around, 1.0);
            widest_share_ = std::max(widest_share_, std::min(around, 1.0));
        }
    }

    const FirstBins& all_;
    Portions portions_;
    std::uint32_t samples_ = 0;     // in lists, before the round
    std::uint64_t first_draw_ = 0;  // the number of the round's first draw
    std::uint64_t next_draw_ = 0;   // and of the next round's
    std::vector<std::uint32_t> third_bits_;
    double mean_share_ = 0;
    double widest_share_ = 0;
};

}  // namespace

std::unique_ptr<Bins> make_portions(RoundMemory& round) {
    return std::make_unique<BinsInSpace>(round);
}

}  // namespace lacuna::device
