// The active boxes of mode exact on a device: how they are refined, whichever neighbour index finds
// the samples that cut them. They are the bins from the first refinement or, with a radius field,
// from the first round.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "backends/backend.h"
#include "backends/device/layout.h"
#include "backends/device/round_memory.h"

namespace lacuna::device {

// See Bins for the order of the calls. A class for each neighbour index derives from this one:
// GridBoxes below, and ListBoxes in list_boxes.h.
class Boxes {
public:
    virtual ~Boxes() = default;
    Boxes(const Boxes&) = delete;
    Boxes& operator=(const Boxes&) = delete;

    std::span<const std::uint32_t> free_lengths() const { return sizes_.first(count_); }
    std::vector<Box> get() const;

    // Makes room for `count` boxes, which a kernel will write.
    void make_room(std::uint32_t count);

    // Queues the cut: boxes are halved first where `halve` is set. With neighbour lists, only
    // samples from entry `first_recent` onwards cut the boxes, which the earlier ones have cut
    // before.
    void refine(bool halve, std::uint32_t first_recent = 0);

    // Returns true if there were more pieces than room. Then it queues writing them with more room.
    bool queue_rest();
    virtual void download();
    virtual void end_round();

protected:
    // What differs between the indices, and does not change.
    struct Kind {
        std::uint32_t strip_bits;    // a halved box is cut into at most 2^strip_bits strips
        std::uint32_t words_of_bin;  // of results[], for each new box
        Span own;                    // boxes with x in it are cut
        // Where the boxes lie, four words each, and those that a refinement makes.
        Buffer Memory::*boxes = &Memory::boxes;
        Buffer Memory::*new_boxes = &Memory::new_boxes;
    };
    Boxes(RoundMemory& round, Kind kind) : round_(round), kind_(kind) {}

    // Replaces the boxes, and what results[] had of them. Waits.
    template <typename Bin>
    void put(std::span<const Bin> boxes, std::vector<std::uint32_t> sizes) {
        static_assert(sizeof(Bin) == 4 * kWord);
        count_ = static_cast<std::uint32_t>(boxes.size());
        round_.put_in_room<Bin>(round_.memory.*kind_.boxes, boxes);
        first_sizes_ = std::move(sizes);
        sizes_ = first_sizes_;
    }

    // How many more boxes than now a refinement is likely to leave.
    virtual std::uint32_t more_boxes(bool halve) const = 0;
    // Makes room for what cut writes of `boxes` boxes, and keep of `room` besides the boxes.
    virtual void make_room_to_cut(std::uint64_t boxes, bool halve);
    virtual void make_room_to_keep(std::uint64_t room) = 0;
    virtual void queue_cut(bool halve) = 0;
    // Writes the pieces, and what results[] has of them.
    virtual void queue_keep() = 0;
    // Queues what is to follow the round's samples.
    virtual void queue_last() {}

    // Serves the first `count` boxes, or new boxes, `chunk` of them for each item.
    template <typename Kernel>
    void launch_over_boxes(std::uint32_t count, std::uint32_t chunk, std::uint64_t work_of_box) {
        launch<Kernel>(round_.queue, round_.memory, arguments(chunk), items_of(count, chunk),
                       work_of_box * chunk);
    }
    std::uint32_t strip_bits() const { return refinement_->is_halving ? kind_.strip_bits : 0; }

    // The work of a box, see Queue::launch.
    static constexpr std::uint64_t kCutWork = 16;
    static constexpr std::uint64_t kKeepWork = 4;

    // A refinement that has been queued.
    struct Refinement {
        bool is_halving;
        std::uint32_t first_recent;
        std::uint32_t room;  // for new boxes
    };

    RoundMemory& round_;
    const Kind kind_;
    std::uint32_t count_ = 0;
    std::span<const std::uint32_t> sizes_;  // words_of_bin words of each box, the lengths first
    std::optional<Refinement> refinement_;

private:
    portable::StripArguments arguments(std::uint32_t chunk) const;
    // In space, bins whose weight is smaller than this are not split.
    virtual std::uint64_t least_to_split() const { return 0; }
    // Queues listing the round's samples behind the boxes.
    virtual void list_samples(RoundMemory::Listing listing) { round_.list_samples(listing); }
    RoundMemory::Listing listing() const;
    void make_room_for_pieces();
    void keep();

    std::vector<std::uint32_t> first_sizes_;  // of boxes that no kernel has made
};

// Boxes cut by the sample grid: all are equally wide.
class GridBoxes final : public Boxes {
public:
    GridBoxes(RoundMemory& round, std::uint32_t width);

    std::uint32_t width() const { return width_; }
    // The first box of each column of lines, then the number of boxes: for Round::bin_begins.
    std::span<const std::uint32_t> begins() const { return bin_begins_; }

    void put(std::span<const Box> boxes);
    void download() override;
    void end_round() override;

private:
    std::uint32_t more_boxes(bool) const override { return 0; }
    void make_room_to_keep(std::uint64_t) override {}
    void queue_cut(bool halve) override;
    void queue_keep() override;
    void queue_last() override;

    std::uint32_t width_;
    std::vector<std::uint32_t> bin_begins_;
};

}  // namespace lacuna::device
