// The active boxes of mode exact on a device, with either neighbour index. They are the bins from
// the first refinement or, with a radius field, from the first round.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "backends/device/layout.h"
#include "backends/device/round_memory.h"

namespace lacuna::device {

// See Bins for the order of the calls.
class Boxes {
public:
    // `width` is 0 where widths differ.
    Boxes(RoundMemory& round, std::uint32_t width);

    // The width of every box; not with a radius field, where widths() has it.
    std::uint32_t width() const { return width_; }
    // The first box of each column of lines, then the number of boxes: for Round::bin_begins.
    std::span<const std::uint32_t> begins() const { return bin_begins_; }
    std::span<const std::uint32_t> free_lengths() const { return sizes_.first(count_); }
    std::span<const std::uint32_t> widths() const {
        return has_field() ? sizes_.subspan(count_, count_) : sizes_.first(0);
    }
    // With classes, as in Round.
    std::span<const std::uint32_t> sheet_ends() const { return sheet_ends_; }

    // Replaces the boxes. `origins`: see portable/kernels.h; empty without a radius field. Waits.
    void put(std::span<const Box> boxes, std::span<const std::uint32_t> origins);
    std::vector<Box> get() const;

    // Makes room for `count` boxes, which a kernel will write.
    void make_room(std::uint32_t count);

    // Queues the cut: boxes are halved first where `halve` is set. With neighbour lists, only
    // samples from entry `first_recent` onwards cut the boxes, which the earlier ones have cut
    // before.
    void refine(bool halve, std::uint32_t first_recent = 0);

    // Returns true if there were more pieces than room. Then it queues writing them with more room.
    bool queue_rest();
    void download();
    void end_round();

private:
    // A refinement that has been queued.
    struct Refinement {
        bool is_halving;
        std::uint32_t first_recent;
        std::uint32_t room;  // for new boxes
    };

    bool has_field() const { return round_.plan.has_field(); }
    std::uint32_t strip_bits() const;
    std::uint32_t expected_pieces(bool halve) const;
    // Serves the first `count` boxes, or new boxes, `chunk` of them for each item.
    template <typename Kernel>
    void launch_over_boxes(std::uint32_t count, std::uint32_t chunk, std::uint64_t work_of_box);
    RoundMemory::Listing listing() const;
    void make_room_for_pieces();
    void keep();
    void set_sizes(std::span<const Box> boxes);

    RoundMemory& round_;
    std::uint32_t width_;
    std::uint32_t count_ = 0;
    std::vector<std::uint32_t> bin_begins_;
    std::span<const std::uint32_t> sizes_;    // lengths; with a radius field then widths
    std::vector<std::uint32_t> first_sizes_;  // of boxes that no kernel has made
    std::vector<std::uint32_t> sheet_ends_;
    std::vector<Box> new_boxes_;  // with classes, as downloaded

    std::optional<Refinement> refinement_;
};

}  // namespace lacuna::device
