// What mode exact adds on the device: the samples by cells, and the boxes that refine leaves.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "backends/vulkan/engine.h"
#include "backends/vulkan/kernels.h"
#include "backends/vulkan/memory.h"
#include "plan/plan.h"

namespace lacuna::vulkan {

class Boxes {
public:
    // All cells are emptied. Recorded.
    Boxes(const Plan& plan, Engine& engine, const Kernels& kernels);

    // Boxes are the places from the first refinement on.
    bool are_places() const { return width_ != 0; }
    std::uint32_t width() const { return width_; }
    std::span<const std::uint32_t> lengths() const;
    std::span<const std::uint32_t> place_begins() const { return place_begins_; }

    // All recorded. What a refinement does, in order; the caller waits where it says so.
    void locate(const Memory& memory, std::uint32_t chunk);
    void screen(const Memory& memory, std::uint32_t chunk);
    void insert(const Memory& memory);
    // At the first refinement, with a wait and a download() in between.
    void count_spans(const Memory& memory);
    void unfold(const Memory& memory);
    void refine(const Memory& memory, bool halve);
    // After the wait: whether there are more pieces than room for them. If so, room is made and
    // they are written again; if not, they are the boxes from now on.
    void download();
    bool lacks_room() const;
    void make_room_and_keep(const Memory& memory);
    void accept();

    void snapshot(Snapshot& snapshot);
    void restore(const Snapshot& snapshot);

private:
    // A buffer for each coordinate: with 10 million points none has more than 128 MiB.
    struct Set {
        std::uint32_t room = 0;
        Buffer x, begin, end;
    };
    void make_room(Set& set, std::uint32_t count);
    void make_tables(std::uint32_t count);
    void scan(const Memory& memory, std::uint32_t count);
    void cut(const Memory& memory);
    void keep(const Memory& memory);
    void find_place_begins(const Memory& memory);
    std::uint32_t is_halved() const { return new_width_ < width_ ? 1 : 0; }
    std::uint32_t strips() const { return count_ << is_halved(); }
    std::uint32_t total() const;

    const Plan& plan_;
    Engine& engine_;
    const Kernels& kernels_;

    Buffer grid_x_, grid_y_;

    std::uint32_t width_ = 0;
    std::uint32_t count_ = 0;
    Set now_;
    std::vector<std::uint32_t> place_begins_;

    // Of a refinement under way.
    std::uint32_t new_width_ = 0;
    std::uint32_t new_room_ = 0;
    Set next_;
    std::uint32_t table_room_ = 0;
    Buffer counts_, sums_, piece_begin_, piece_end_;
    Buffer total_, lengths_, place_begins_made_;
    Buffer total_down_, lengths_down_, place_begins_down_;
};

}  // namespace lacuna::vulkan
