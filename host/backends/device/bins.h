// The places of a mode on the device: where draws fall, and what samples take from them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "backends/backend.h"
#include "backends/device/layout.h"
#include "backends/device/round_memory.h"

namespace lacuna::device {

// Every call but the last few queues work on the round's memory.
class Bins {
public:
    explicit Bins(RoundMemory& round) : round_(round) {}
    virtual ~Bins() = default;
    Bins(const Bins&) = delete;
    Bins& operator=(const Bins&) = delete;

    // The first box of each column; columns + 1.
    virtual std::span<const std::uint32_t> begins() const = 0;
    // Of a round of so many draws.
    virtual PartLimits part_limits(std::uint32_t) const { return {}; }
    // After a part of the round's draws, or of its candidates restored, was opened.
    virtual void begin_part() = 0;
    virtual void locate(std::span<const Draw> draws) = 0;
    // What was located, into the order in which admit looks for it.
    virtual void sort() { round_.sort(); }
    // Before the first pass of the first part: settles what samples of earlier rounds cover.
    virtual void screen() {}
    // Before the first pass of a later part: settles what samples of earlier parts cover, of the
    // draws from the part's begin to `end`.
    virtual void screen_again(std::uint32_t end) = 0;
    virtual void admit(std::uint32_t pass) = 0;
    virtual void subtract() = 0;
    // Takes the part's samples out, so that screen_again sees them. In exact they are only put into
    // the grid, and subtract is still to do.
    virtual void take_out() { subtract(); }
    virtual bool is_cut_by_take_out() const { return true; }
    // What refine must know before it can be queued, see there; false: nothing.
    virtual bool queue_before_refine() { return false; }
    virtual void refine(bool halve) = 0;

    // What a round hands back on its way down, with flags.
    virtual void start_download() = 0;
    // By these flags, what else the round takes once admission is settled; false: nothing.
    virtual bool queue_rest() = 0;
    // Once that is nothing.
    virtual void end_round() {}

    virtual std::span<const std::uint32_t> free_lengths() const = 0;
    virtual std::uint32_t width() const = 0;
    // Of each place, where they differ.
    virtual std::span<const std::uint32_t> widths() const { return {}; }
    virtual void snapshot(Snapshot& snapshot) = 0;
    virtual void restore(const Snapshot& snapshot) = 0;

protected:
    RoundMemory& round_;
};

// Those of the plan's mode.
std::unique_ptr<Bins> make_spans(RoundMemory& round, const Tuning& tuning);    // lines, exact
std::unique_ptr<Bins> make_lattice(RoundMemory& round, const Tuning& tuning);  // cells
std::unique_ptr<Bins> make_field_boxes(RoundMemory& round);  // exact with a radius field

}  // namespace lacuna::device
