// What mode exact adds on the device: the sample grid, and the boxes that refine leaves.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "backends/device/layout.h"
#include "backends/device/round_memory.h"

namespace lacuna::device {

// See Places for the order of the calls.
class Boxes {
public:
    explicit Boxes(RoundMemory& round);

    // Whether there are boxes: from the first refinement on.
    bool are_places() const { return width_ != 0; }
    std::uint32_t width() const { return width_; }
    std::span<const std::uint32_t> begins() const { return bin_begins_; }
    std::span<const std::uint32_t> free_lengths() const {
        return std::span(free_lengths_).first(count_);
    }

    void locate();
    void screen();
    void screen_again(std::uint32_t end);
    // The round's samples, into the grid.
    void insert();

    // At the first refinement: the boxes of each slab's spans are counted, all counts summed; then,
    // after a wait, room is made and they are written.
    void make_room_to_count();
    void unfold(const Memory& memory, portable::SlabArguments arguments, const Slab& slab,
                bool is_counting);
    void scan_lines();
    void make_room_for_lines();

    void refine(bool halve);

    void start_download();
    // True where more pieces were left than there was room for: they are written again.
    bool queue_rest();
    void end_round();

    void snapshot(Snapshot& snapshot);
    void restore(const Snapshot& snapshot);

private:
    // Room for so many boxes, or to count and sum what is left of so many lines or strips.
    void make_boxes(Buffer& x, Buffer& begin, Buffer& end, std::uint64_t count);
    void make_tables(std::uint64_t count);
    void keep();
    std::uint32_t is_halved() const { return new_width_ < width_ ? 1 : 0; }
    std::uint32_t strips() const { return count_ << is_halved(); }
    portable::StripArguments strip_arguments(std::uint32_t served) const;

    RoundMemory& round_;
    std::uint32_t width_ = 0;
    std::uint32_t count_ = 0;
    std::vector<std::uint32_t> bin_begins_;
    std::vector<std::uint32_t> free_lengths_;

    // Of a refinement under way.
    std::uint32_t new_width_ = 0;
    std::uint32_t new_room_ = 0;
    std::array<std::uint32_t, 1> total_{};
};

}  // namespace lacuna::device
