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

#include "backends/cpu/state.h"
#include "portable/status.h"

namespace lacuna::cpu {

// Draws [begin, end) of a round, by their order.
struct Part {
    std::uint32_t begin;
    std::uint32_t end;
};

template <typename ModeState>
class Crowd {
public:
    // Takes the round out of the state, which then holds one part of it at a time.
    explicit Crowd(ModeState& state) { exchange(state); }
    void give_back(ModeState& state) { exchange(state); }

    // For each column, in this order: screen rejects the part's draws that samples of earlier parts
    // cover, move_in copies the others into the state to be admitted, and move_out copies their
    // statuses back.
    void screen(const ModeState& state, std::uint32_t column, Part part) {
        std::uint32_t left = 0;
        for (std::uint32_t i = begins_[column]; i < begins_[column + 1]; ++i) {
            if (!is_open(i, part)) continue;
            if (part.begin > 0 && is_covered(state, candidates_[i]))
                statuses_[i] = STATUS_REJECTED;
            else
                ++left;
        }
        left_[column + 1] = left;
    }
    void make_room(ModeState& state) {
        std::inclusive_scan(left_.begin(), left_.end(), state.column_begins.begin());
        const std::size_t left = state.column_begins.back();
        origins_.resize(left);
        state.make_room(left);
    }
    void move_in(ModeState& state, std::uint32_t column, Part part) {
        std::uint32_t to = state.column_begins[column];
        for (std::uint32_t i = begins_[column]; i < begins_[column + 1]; ++i) {
            if (!is_open(i, part)) continue;
            origins_[to] = i;
            state.candidates[to++] = candidates_[i];
        }
        set_undecided(state, column);
    }
    void move_out(const ModeState& state, std::uint32_t column) {
        for (std::uint32_t i = state.column_begins[column]; i < state.column_begins[column + 1];
             ++i)
            statuses_[origins_[i]] = state.statuses[i];
    }

private:
    bool is_open(std::uint32_t i, Part part) const {
        return candidates_[i].order - part.begin < part.end - part.begin &&
               statuses_[i] == STATUS_UNDECIDED;
    }
    void exchange(ModeState& state) {
        if (begins_.empty()) begins_.resize(state.column_begins.size());
        left_.resize(begins_.size());
        std::swap(candidates_, state.candidates);
        std::swap(begins_, state.column_begins);
        std::swap(statuses_, state.statuses);
    }

    std::vector<Candidate> candidates_;
    std::vector<std::uint32_t> begins_;
    std::vector<std::uint32_t> statuses_;
    std::vector<std::uint32_t> left_;     // left_[c + 1]: the part's open draws in column c
    std::vector<std::uint32_t> origins_;  // index in candidates_ of each candidate in the state
};

}  // namespace lacuna::cpu
