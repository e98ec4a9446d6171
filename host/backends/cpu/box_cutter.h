// Cuts active boxes by the samples near them, eight boxes at a time (docs/design.md, section 4,
// "exact").
//
// A plan has one rule: OneRadius (one_radius.h), or Radii, Classes or Ellipses (list_rules.h). It
// finds the samples near a box and says which of these touch a box, which cover it, and which chord
// each of them takes from it.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "backends/cpu/vectors.h"
#include "base/insertion_sort.h"
#include "plan/plan.h"
#include "portable/chord.h"
#include "portable/distance.h"
#include "portable/ellipse.h"

namespace lacuna::cpu {

// The heights that a sample takes from a box, for the whole width of the box.
inline portable::Interval disk_chord(Sample at, std::uint64_t limit_squared, const Box& box,
                                     std::uint32_t period_x) {
    const std::uint32_t half = box.width / 2;
    const std::uint32_t dx = portable::axis_distance(at.x, box.x + half, period_x) + half;
    if (portable::squared_length(dx, 0) >= limit_squared) return {0, 0};
    const std::int64_t reach = portable::chord_reach(dx, limit_squared);
    return {at.y + 1 - reach, at.y + reach};
}

// The numbers of the samples that touch each box of a batch.
class Touching {
public:
    void begin(std::size_t samples) {
        counts_.fill(0);
        if (numbers_.size() <= samples) numbers_.resize(2 * samples + 1);
    }
    // Lists the samples below `samples` for which touches(sample) is true. There is no branch,
    // which could not be predicted.
    template <typename Touches>
    void find(std::size_t box, std::size_t samples, Touches touches) {
        std::size_t count = 0;
        for (std::size_t sample = 0; sample < samples; ++sample) {
            numbers_[count][box] = static_cast<std::uint32_t>(sample);
            count += std::size_t{touches(sample)};
        }
        counts_[box] = count;
    }
    // Adds the sample to the boxes of these bits.
    void add(std::size_t sample, unsigned bits) {
        for (; bits != 0; bits &= bits - 1) {
            const auto box = static_cast<std::size_t>(std::countr_zero(bits));
            numbers_[counts_[box]++][box] = static_cast<std::uint32_t>(sample);
        }
    }
    std::size_t count(std::size_t box) const { return counts_[box]; }
    std::size_t number(std::size_t nth, std::size_t box) const { return numbers_[nth][box]; }

private:
    std::array<std::size_t, BoxBatch::kBoxes> counts_{};
    std::vector<std::array<std::uint32_t, BoxBatch::kBoxes>> numbers_;  // [n-th sample][box]
};

template <typename Rule>
class BoxCutter {
public:
    using Active = typename Rule::Active;

    // A thread's memory, reused from column to column.
    struct Scratch {
        std::vector<Active> left;
        Touching touching;
        std::vector<Span> chords;
    };
    BoxCutter(Rule& rule, Scratch& scratch)
        : rule_(rule),
          height_(rule.plan().height),
          left_(scratch.left),
          touching_(scratch.touching),
          chords_(scratch.chords) {
        if constexpr (!Rule::kIsBatched) touching_.begin(Rule::kMostNear);
    }

    // Fills scratch.left with the pieces of boxes, or of their halves.
    void refine(std::span<const Active> boxes) {
        left_.clear();
        while (!boxes.empty()) {
            const std::span<const Active> group = boxes.first(rule_.group_size(boxes));
            rule_.fetch(boxes[std::min(Rule::kAhead, boxes.size() - 1)]);
            boxes = boxes.subspan(group.size());
            if (rule_.begin(group.front()))
                cut_group(group);
            else
                left_.insert(left_.end(), group.begin(), group.end());
        }
    }

private:
    void cut_group(std::span<const Active> group) {
        const std::size_t before = left_.size();
        while (!group.empty()) {
            const std::size_t served = rule_.find_near(group);
            for (const Active& active : group.first(served))
                rule_.for_each_part(active, [&](const Box& part) { add(part); });
            if constexpr (Rule::kIsBatched) {
                if (count_ != 0) cut_batch();
            }
            group = group.subspan(served);
        }
        rule_.end(left_.size() == before);
    }

    void add(const Box& part) {
        if constexpr (Rule::kIsBatched) {
            rule_.set(count_, part);
            batch_.set(count_++, part);
            if (count_ == BoxBatch::kBoxes) cut_batch();
        } else {
            if (!rule_.find_touching(part, touching_)) cut(part, 0);
        }
    }

    // Most boxes are untouched or covered by one sample; few are touched by several.
    void cut_batch() {
        touching_.begin(rule_.near_count());
        const unsigned covered = rule_.find_touching(batch_, count_, touching_);
        for (std::size_t i = 0; i < count_; ++i)
            if ((covered >> i & 1) == 0) cut(batch_[i], i);
        count_ = 0;
    }

    // Where samples may be nearer across an edge of the torus, all of them are tried, and a chord
    // has up to three parts.
    void cut(const Box& box, std::size_t i) {
        const bool wraps = rule_.wraps(box);
        const std::size_t samples = wraps ? rule_.near_count() : touching_.count(i);
        if (samples == 0) return left_.push_back(rule_.active(box));
        if (chords_.size() <= 3 * samples) chords_.resize(6 * samples);
        std::size_t count = 0;
        for (std::size_t n = 0; n < samples; ++n) {
            const portable::Interval chord =
                rule_.chord(wraps ? n : touching_.number(n, i), i, box);
            if (chord.begin >= chord.end) continue;
            const auto covers = [&](std::uint32_t window) {
                const Span there{portable::height_in_window(window, chord.begin, height_),
                                 portable::height_in_window(window, chord.end, height_)};
                chords_[count] = there;
                count += std::size_t{there.begin < there.end};
                return there.begin <= box.begin && there.end >= box.end;
            };
            if (covers(0)) return;
            if (wraps && chord.begin < 0 && covers(1)) return;
            if (wraps && chord.end > height_ && covers(2)) return;
        }
        append_pieces(box, std::span(chords_).first(count));
    }

    // Appends what the chords leave of the box.
    void append_pieces(const Box& box, std::span<Span> chords) {
        insertion_sort(chords, [](Span a, Span b) { return a.begin < b.begin; });
        std::uint32_t free_from = box.begin;
        const auto append = [&](std::uint32_t free_to) {
            if (free_from < free_to)
                left_.push_back(rule_.active({box.x, box.width, free_from, free_to}));
        };
        for (const Span chord : chords) {
            append(std::min(chord.begin, box.end));
            free_from = std::max(free_from, chord.end);
        }
        append(box.end);
    }

    Rule& rule_;
    std::uint32_t height_;
    std::vector<Active>& left_;
    BoxBatch batch_;
    std::size_t count_ = 0;  // of boxes in the batch
    Touching& touching_;
    std::vector<Span>& chords_;
};

}  // namespace lacuna::cpu
