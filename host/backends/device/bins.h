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

    // Round::bin_begins.
    virtual std::span<const std::uint32_t> begins() const { return {}; }
    // If candidates are sorted column by column: the first bin of each column, then the number of
    // bins. Otherwise empty.
    virtual std::span<const std::uint32_t> sorted_columns() const { return {}; }
    // The limits of the parts of a round of `count` draws.
    virtual PartLimits part_limits(std::uint32_t) const { return {}; }
    // Called once a round's draws, or restored candidates, are uploaded.
    virtual void begin_round() {}
    // Called after a part of them was opened.
    virtual void begin_part() {}
    virtual void locate(std::span<const Draw> draws) = 0;
    // Sorts the located candidates into the order that admit needs.
    virtual void sort() {}
    // Gives undecided draws this status if samples cover them: in exact, before the first pass of
    // the first part, samples of earlier rounds; in all modes, before a later part, samples of
    // earlier parts. With `opens` the draws are the open part, and admit may look for them.
    virtual void screen(Range draws, std::uint32_t status, bool opens) = 0;
    virtual void admit(std::uint32_t pass) = 0;
    virtual void subtract() = 0;
    // Puts the part's samples where screen finds them. At the end of the round subtract or refine
    // does so for the last part.
    virtual void take_out() = 0;
    virtual void refine(bool halve) = 0;

    // Queues what the report shows that the round still needs; returns false if that is nothing.
    virtual bool queue_rest() { return false; }
    // Queues the download of the results of subtract or refine, once the round is complete.
    virtual void download() = 0;
    // Called once they have arrived.
    virtual void end_round() {}

    virtual std::span<const std::uint32_t> free_lengths() const = 0;
    virtual std::uint32_t width() const = 0;
    // The width of each bin, where widths differ.
    virtual std::span<const std::uint32_t> widths() const { return {}; }
    // With classes: the number of bins up to the end of each copy.
    virtual std::span<const std::uint32_t> copy_ends() const { return {}; }
    virtual void snapshot(Snapshot& snapshot) = 0;
    virtual void restore(const Snapshot& snapshot) = 0;
    // Uploads restored candidates. Waits.
    virtual void put_candidates(std::vector<Candidate>& candidates) {
        round_.put_in_room<Candidate>(round_.memory.candidates, candidates);
    }

protected:
    RoundMemory& round_;
};

// The bins of the plan's mode.
std::unique_ptr<Bins> make_spans(RoundMemory& round, const Tuning& tuning);    // lines, exact
std::unique_ptr<Bins> make_lattice(RoundMemory& round, const Tuning& tuning);  // cells
std::unique_ptr<Bins> make_field_boxes(RoundMemory& round);  // exact with a radius field
std::unique_ptr<Bins> make_portions(RoundMemory& round);     // surfaces and volumes

}  // namespace lacuna::device
