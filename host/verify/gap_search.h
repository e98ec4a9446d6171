// One thread's part of the search for the largest gap.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "verify/bounds.h"
#include "verify/cell.h"
#include "verify/domain.h"
#include "verify/largest_gap.h"
#include "verify/patience.h"
#include "verify/radius_field.h"

namespace lacuna::verify {

// What a search for the largest gap is given.
struct Question {
    const RadiusField& radius_field;
    double tolerance;    // a spot that is over its limit by no more than this is covered
    bool names_any_gap;  // the largest gap is wanted even where every spot is covered
    double precision;    // larger gaps are not looked for if they are larger by less than this
    double finest;       // share, or by less than this distance
    double rounding;     // the largest error of a distance
    const Patience& patience;
};

// Whether a new list of the `kept` ones of many `samples` is not worth its memory, because it would
// be nearly as long. For example, all samples on one circle matter to every cell around its centre,
// so each cut would list them once more.
bool drops_few(std::size_t samples, std::size_t kept);

// `Sample` is Disk or Ellipse.
template <typename Sample>
class GapSearch {
public:
    GapSearch(const Question& question, const Gap& start) : question_(question), gap_(start) {}

    // The largest gap found in the cell, or the start if no gap is larger; see largest_gap.
    Gap run(const Cell& cell, const Under& under, std::vector<Sample> samples);

private:
    // The samples that matter to the cell are on the stack, from index `begin` to its end.
    void visit(const Cell& cell, const Under& outer, std::size_t begin);
    // Pushes the samples in [begin, end) of the stack that matter to the cell, where no spot is
    // over its limit by more than `most_over`.
    void push_those_that_matter(const Cell& cell, const Bounds<Sample>& bounds, double most_over,
                                std::size_t begin, std::size_t end);
    // Keeps the gap at the cell's centre if it is larger than any other found until now. Returns
    // the index of the sample that covers the centre best.
    std::size_t look_from(const Cell& cell, Point centre, const Under& under, std::size_t begin);
    // A cell needs no cutting if none of its spots is over its limit by more than this.
    double decided_from() const;

    const Question& question_;
    Gap gap_;
    std::uint32_t visits_ = 0;
    std::vector<Sample> stack_;  // the samples of each cell from the first one to the one visited
};

}  // namespace lacuna::verify
