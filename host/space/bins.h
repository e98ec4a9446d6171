// The bins of a round on the cpu, block by block, and their splitting.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/workers.h"
#include "space/first_bins.h"
#include "space/portion.h"
#include "space/samples.h"

namespace lacuna::space {

class Bins {
public:
    Bins(const FirstBins& all, std::uint64_t radius_squared, Workers& workers);

    // Blocks that have bins, in order. Those of block(i) are [begin(i), begin(i + 1)).
    std::uint32_t blocks() const { return static_cast<std::uint32_t>(blocks_.size()); }
    std::uint32_t block(std::uint32_t i) const { return blocks_[i]; }
    std::uint32_t begin(std::uint32_t i) const { return begins_[i]; }
    const Portion& operator[](std::size_t bin) const { return now_[bin]; }

    // Blocks are shared out to tasks in runs with about equally many bins.
    std::uint32_t runs() const { return static_cast<std::uint32_t>(run_begins_.size() - 1); }
    Span run(std::uint32_t i) const { return {run_begins_[i], run_begins_[i + 1]}; }
    std::size_t size() const { return now_.size(); }

    std::span<const std::uint32_t> lengths() const { return lengths_; }
    std::span<const std::uint32_t> widths() const { return widths_; }

    // Splits each bin, if that is wanted, and drops what one sample covers.
    void refine(const Samples& samples, bool halve, Workers& workers);

private:
    void mark(const Samples& samples, Span blocks);
    void take_marked(Workers& workers);
    void find_runs();
    void weigh(Workers& workers);

    const FirstBins& all_;
    std::uint64_t radius_squared_;
    std::span<const Portion> now_;  // the first bins, or pieces_
    std::vector<Portion> pieces_;
    // Of each bin, bits of the pieces that stay, and whether it is split into pieces.
    std::vector<std::uint16_t> kept_;
    static constexpr std::uint16_t kSplits = 256;
    std::vector<std::uint32_t> blocks_;
    std::vector<std::uint32_t> begins_;
    std::vector<std::uint32_t> run_begins_;
    std::vector<std::uint32_t> lengths_;
    std::vector<std::uint32_t> widths_;
    std::uint64_t total_ = 0;  // weight of all bins
    std::uint64_t least_to_split_ = 0;
};

}  // namespace lacuna::space
