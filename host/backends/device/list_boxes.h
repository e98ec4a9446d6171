// The active boxes of mode exact with a radius field on a device: the samples in neighbour lists
// cut them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backends/device/boxes.h"

namespace lacuna::device {

class ListBoxes final : public Boxes {
public:
    explicit ListBoxes(RoundMemory& round);

    std::span<const std::uint32_t> widths() const { return sizes_.subspan(count_, count_); }
    // With classes, as in Round.
    std::span<const std::uint32_t> copy_ends() const { return copy_ends_; }

    // `origins` has two words for each box: see Origin in portable/elements.h.
    void put(std::span<const Box> boxes, std::span<const std::uint32_t> origins);
    void download() override;
    void end_round() override;

private:
    // The number of boxes stays about the same, or grows if pixels are unlike.
    std::uint32_t more_boxes(bool halve) const override { return halve ? count_ : count_ / 32; }
    void make_room_to_cut(std::uint64_t boxes, bool halve) override;
    void make_room_to_keep(std::uint64_t room) override;
    void queue_cut(bool halve) override;
    void queue_keep() override;

    std::vector<std::uint32_t> copy_ends_;
    std::vector<Box> new_boxes_;  // with classes, as downloaded
};

}  // namespace lacuna::device
