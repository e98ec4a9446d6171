// Rounds that crowd: most draws conflict with others of the round, so that the time to compare all
// pairs would grow with the square of the number of draws.
//
// Such a round is admitted in parts, in the order of the draws. The samples of each part are cut
// from the bins. So one look at the bin decides most draws of the next part, and only the others
// are compared with each other. Each part has as many draws as all earlier parts together. If the
// draw after the first n is free with probability p, about n p or more of these became samples, and
// about n p or fewer of the next n draws are free. So a part compares no more draws than there are
// samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "backends/cpu/sorted_bins.h"
#include "base/workers.h"
#include "portable/status.h"

namespace lacuna::cpu {

class Crowd {
public:
    // Takes the round out of the bins, which then hold one part of it at a time.
    Crowd(SortedBins& bins, Workers& workers)
        : bins_(bins), workers_(workers), begins_(bins.round.column_begins.size()) {
        exchange();
        left_.resize(begins_.size());
    }
    void give_back() { exchange(); }

    // Rejects the draws [begin, end) that samples of earlier parts cover, and puts the others into
    // the bins, to be admitted.
    void open_part(std::uint32_t begin, std::uint32_t end) {
        begin_ = begin;
        end_ = end;
        for_columns([&](std::uint32_t column) { screen(column); });
        std::inclusive_scan(left_.begin(), left_.end(), bins_.round.column_begins.begin());
        origins_.resize(bins_.round.column_begins.back());
        bins_.make_room(origins_.size());
        for_columns([&](std::uint32_t column) { move_in(column); });
        bins_.end_locate();
    }
    // Copies the statuses of the part's draws.
    void close_part() {
        for_columns([&](std::uint32_t column) {
            const std::uint32_t end = bins_.round.column_begins[column + 1];
            for (std::uint32_t i = bins_.round.column_begins[column]; i < end; ++i)
                statuses_[origins_[i]] = bins_.round.statuses[i];
        });
    }

private:
    template <typename Work>
    void for_columns(Work work) {
        workers_.for_columns(bins_.round.columns, end_, work);
    }
    bool is_open(std::uint32_t i) const {
        return candidates_[i].order - begin_ < end_ - begin_ && statuses_[i] == STATUS_UNDECIDED;
    }
    void screen(std::uint32_t column) {
        std::uint32_t left = 0;
        for (std::uint32_t i = begins_[column]; i < begins_[column + 1]; ++i) {
            if (!is_open(i)) continue;
            if (begin_ > 0 && bins_.is_covered(candidates_[i]))
                statuses_[i] = STATUS_REJECTED;
            else
                ++left;
        }
        left_[column + 1] = left;
    }
    void move_in(std::uint32_t column) {
        std::uint32_t to = bins_.round.column_begins[column];
        for (std::uint32_t i = begins_[column]; i < begins_[column + 1]; ++i) {
            if (!is_open(i)) continue;
            origins_[to] = i;
            bins_.round.candidates[to++] = candidates_[i];
        }
        bins_.set_undecided(column);
    }
    void exchange() {
        std::swap(candidates_, bins_.round.candidates);
        std::swap(begins_, bins_.round.column_begins);
        std::swap(statuses_, bins_.round.statuses);
    }

    SortedBins& bins_;
    Workers& workers_;
    std::uint32_t begin_ = 0;  // of the part, by order
    std::uint32_t end_ = 0;
    std::vector<Candidate> candidates_;
    std::vector<std::uint32_t> begins_;
    std::vector<std::uint32_t> statuses_;
    std::vector<std::uint32_t> left_;     // left_[c + 1]: the part's open draws in column c
    std::vector<std::uint32_t> origins_;  // index in candidates_ of each candidate in the bins
};

}  // namespace lacuna::cpu
