// The bins of a mode on a device: draws fall on them, and samples are cut from them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "backends/device/layout.h"
#include "backends/device/round_memory.h"

namespace lacuna::device {

// The calls up to start_download queue work on the round's memory.
class Bins {
public:
    explicit Bins(RoundMemory& round) : round_(round) {}
    virtual ~Bins() = default;
    Bins(const Bins&) = delete;
    Bins& operator=(const Bins&) = delete;

    // The first bin of each column, then the number of bins.
    virtual std::span<const std::uint32_t> begins() const = 0;
    // The limits of the parts of a round of `count` draws.
    virtual PartLimits part_limits(std::uint32_t) const { return {}; }
    // Called after a part of the round's draws, or of restored candidates, was opened.
    virtual void begin_part() = 0;
    virtual void locate(std::span<const Draw> draws) = 0;
    // Sorts the located candidates into the order that admit needs.
    virtual void sort() { round_.sort(); }
    // Gives undecided draws this status if samples cover them: in exact, before the first pass of
    // the first part, samples of earlier rounds; in all modes, before a later part, samples of
    // earlier parts.
    virtual void screen(Range draws, std::uint32_t status) = 0;
    virtual void admit(std::uint32_t pass) = 0;
    virtual void subtract() = 0;
    // Cuts the part's samples from the bins, so that screen sees them. In exact it only puts
    // them into the grid, and subtract is still to do.
    virtual void take_out() { subtract(); }
    virtual bool is_cut_by_take_out() const { return true; }
    virtual void refine(bool halve) = 0;

    // Queues the download of the round's results and flags.
    virtual void start_download() = 0;
    // Queues what these flags show that the round still needs; returns false if that is nothing.
    virtual bool queue_rest() = 0;
    // Called after queue_rest() has returned false.
    virtual void end_round() {}

    virtual std::span<const std::uint32_t> free_lengths() const = 0;
    virtual std::uint32_t width() const = 0;
    // The width of each bin, where widths differ.
    virtual std::span<const std::uint32_t> widths() const { return {}; }
    // With classes: the number of bins up to the end of each sheet.
    virtual std::span<const std::uint32_t> sheet_ends() const { return {}; }
    virtual void snapshot(Snapshot& snapshot) = 0;
    virtual void restore(const Snapshot& snapshot) = 0;
    // Uploads restored candidates, which sort() then sorts. Waits.
    virtual void put_candidates(std::vector<Candidate>& candidates) {
        round_.put<Candidate>(round_.memory.located, candidates);
        round_.queue.wait();
    }

protected:
    RoundMemory& round_;
};

// The bins of the plan's mode.
std::unique_ptr<Bins> make_spans(RoundMemory& round, const Tuning& tuning);    // lines, exact
std::unique_ptr<Bins> make_lattice(RoundMemory& round, const Tuning& tuning);  // cells
std::unique_ptr<Bins> make_field_boxes(RoundMemory& round);  // exact with a radius field

}  // namespace lacuna::device
