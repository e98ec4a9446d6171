// The bins of a mode on the cpu: draws fall on them, and samples are cut from them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include "backends/backend.h"
#include "backends/cpu/round_memory.h"
#include "base/workers.h"
#include "plan/plan.h"

namespace lacuna::cpu {

// The round's memory and the verbs of a round. Threads serve columns of bins.
class Bins {
public:
    Bins(const Plan& plan, Workers& workers, std::uint32_t columns)
        : round(plan, columns), workers_(workers) {}
    virtual ~Bins() = default;
    Bins(const Bins&) = delete;
    Bins& operator=(const Bins&) = delete;

    // Before the first round: makes all bins free.
    virtual void set_free() = 0;
    // Turns the draws into undecided candidates. In exact, finds those that samples of earlier
    // rounds cover.
    virtual void locate(std::span<const Draw> draws) = 0;
    // In exact: finds restored candidates that samples of earlier rounds cover.
    virtual void screen() {}
    // Decides all candidates. Returns whether it has also cut the samples from the bins. In exact
    // it puts them into the neighbour index.
    virtual bool admit() = 0;
    // In exact: puts restored samples of the round into the neighbour index.
    virtual void insert() {}
    virtual void subtract() = 0;
    virtual void refine(bool) { throw std::logic_error("this mode has nothing to refine"); }

    // The width of all bins, and of each bin where widths differ.
    virtual std::uint32_t width() const { return round.plan.strip_width; }
    virtual std::span<const std::uint32_t> widths() const { return {}; }
    // With classes, as in Round.
    virtual std::span<const std::uint32_t> copy_ends() const { return {}; }

    // Candidates, statuses and what the mode has. A snapshot shows the round's samples in the
    // neighbour index only after the round's last verb: `left_out` are samples to leave out.
    virtual Snapshot snapshot(std::span<const Sample>) const { return round.snapshot(); }
    virtual void restore(const Snapshot& snapshot) = 0;

    RoundMemory round;
    std::vector<std::uint32_t> begins;        // the first bin of each column, then their number
    std::vector<std::uint32_t> free_lengths;  // of each bin

protected:
    // Calls work(column) for all columns; `amount` is the number of items in all columns together.
    template <typename Work>
    void for_columns(std::size_t amount, Work work) {
        workers_.for_columns(round.columns, amount, work);
    }

    Workers& workers_;
};

// The bins of each mode.
std::unique_ptr<Bins> make_line_bins(const Plan& plan, Workers& workers);      // lines
std::unique_ptr<Bins> make_lattice(const Plan& plan, Workers& workers);        // cells
std::unique_ptr<Bins> make_uniform_boxes(const Plan& plan, Workers& workers);  // exact
std::unique_ptr<Bins> make_field_boxes(const Plan& plan, Workers& workers);  // with a radius field

}  // namespace lacuna::cpu
