// Cuts boxes with a radius field, block by block, by the samples near each block.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "backends/cpu/chords.h"
#include "backends/cpu/field_state.h"
#include "base/insertion_sort.h"
#include "portable/chord.h"
#include "portable/conflict.h"
#include "portable/distance.h"

namespace lacuna::cpu {

class FieldCut {
public:
    FieldCut(const FieldState& state, std::uint32_t region, std::vector<FieldState::BlockBox>& left)
        : state_(state),
          sheets_(state.plan.field().sheets),
          is_at_edge_(wraps(state.first.regions[region])),
          left_(left) {}

    // Boxes that are appended from here on are parts of this block.
    void begin(std::uint32_t block) {
        block_ = block;
        even_radius_ = state_.first.blocks[block].even_radius;
        wraps_ = is_at_edge_ && wraps(state_.first.blocks[block].node);
        sheet_ = sheets_.of(state_.first.nodes[state_.first.blocks[block].node].box.x);
    }
    // Boxes that are appended from here on are cut by these samples.
    void cut_by(const SizedSpan& near) {
        near_ = all_near_ = near;
        if (has_classes_ && even_radius_ != 0) see_with(even_radius_);
        if (!has_ellipses_) return;
        near_ellipses_.clear();
        for (std::size_t i = 0; i < near.count; ++i)
            near_ellipses_.push_back(state_.radius_field.ellipse_at(near[i].x, near[i].y));
    }

    void append_halves(const Box& box) {
        const std::uint32_t cut =
            even_radius_ != 0 ? middle_of(box) : state_.radius_field.cut_x(box);
        if (cut == 0) return append_parts(box);
        append_parts({box.x, cut - box.x, box.begin, box.end});
        append_parts({cut, box.x + box.width - cut, box.begin, box.end});
    }

    void append(const Box& box) { append(box, least_under(box)); }

    // Appends the pieces of all boxes of the block, or of their halves.
    void append_all(std::span<const FieldState::BlockBox> boxes, bool halve) {
        for (const FieldState::BlockBox& box : boxes) {
            const std::uint32_t cut = halve ? middle_of(box.at) : 0;
            if (cut == 0) {
                batch(box.at);
                continue;
            }
            const auto& [x, width, begin, end] = box.at;
            batch({x, cut - x, begin, end});
            batch({cut, x + width - cut, begin, end});
        }
        append_batch();
    }
    // Whether append_all can be called for the block.
    bool can_append_all(bool halve) const {
        return !wraps_ && ((!halve && !has_classes_) || even_radius_ != 0);
    }

private:
    std::uint32_t least_under(const Box& box) const {
        return even_radius_ != 0 ? even_radius_ : state_.radius_field.under(box).least;
    }

    // Whether the nearest way from a sample to a box in the node may cross an edge of the torus.
    bool wraps(std::uint32_t node) const {
        const Plan& plan = state_.plan;
        if (plan.period_x == 0) return false;
        const auto& [box, greatest, next, first, whole] = state_.first.nodes[node];
        const std::uint32_t x = sheets_.x_on_sheet(box.x);
        const std::uint32_t most =
            portable::times_factor(greatest, sheets_.greatest_factor(sheets_.of(box.x)));
        return x < most || plan.width - (x + box.width) < most || box.begin < most ||
               plan.height - box.end < most;
    }

    // With classes: the samples near become what the block's sheet sees of them, with the distances
    // that they keep from samples of this radius.
    void see_with(std::uint32_t radius) {
        seen_.see(sheets_, sheet_, all_near_, radius);
        near_ = seen_.span();
    }
    // The radius of a box that near_ does not know of yet.
    std::uint32_t own_radius(std::uint32_t radius) const {
        return has_classes_ ? kAnyRadius : radius;
    }

    // A chord spans the whole width of the box. Its radius is the smaller of the sample's and the
    // box's, so that the sample conflicts with every point in it.
    void append(const Box& box, std::uint32_t least) {
        if (has_ellipses_)
            return append_with_ellipses(box, near_.count, [](std::size_t i) { return i; });
        if (has_classes_ && even_radius_ == 0) see_with(least);
        const std::uint32_t radius = own_radius(least);
        chords_.resize(std::max(chords_.size(), 3 * near_.count + kVectorPadding));
        const std::size_t count =
            wraps_ ? find_chords_around(box, radius)
                   : vectors_.find_sized_chords(near_, box, radius, chords_.data());
        if (count != Vectors::kAll) append_pieces(box, count);
    }

    // The same with ellipses, for the samples index_of(0) to index_of(samples - 1). A box where no
    // sample may lie stays whole until it is halved.
    template <typename IndexOf>
    void append_with_ellipses(const Box& box, std::size_t samples, IndexOf index_of) {
        const RadiusField& field = state_.radius_field;
        const Under under =
            even_radius_ != 0 ? Under{even_radius_, even_radius_, true} : field.under(box);
        if (under.least == 0) return left_.push_back({box, block_});
        const portable::Ellipse of_box = field.ellipse_under(box, under);
        reaching_.clear();
        for (std::size_t i = 0; i < samples; ++i) {
            const std::size_t k = index_of(i);
            const EllipseAt of_sample{near_ellipses_[k], near_[k]}, there{of_box, near_[k]};
            if (!wraps_ && (misses(of_sample, box) || misses(there, box))) continue;
            if (!wraps_ && covers(of_sample, box) && covers(there, box)) return;
            reaching_.push_back(k);
        }
        chords_.resize(std::max(chords_.size(), 3 * reaching_.size()));
        std::size_t count = 0;
        for (const std::size_t k : reaching_) {
            count = add_ellipse_chord(box, of_box, k, count);
            if (count == Vectors::kAll) return;
        }
        append_pieces(box, count);
    }

    struct EllipseAt {
        const portable::Ellipse& ellipse;
        Sized middle;
    };
    // The offsets of a box's sides from the middle of an ellipse.
    struct Offsets {
        Offsets(const EllipseAt& at, const Box& box)
            : left(std::int64_t{box.x} - at.middle.x),
              right(left + 2 * std::int64_t{box.width / 2}),
              low(std::int64_t{box.begin} - at.middle.y),
              high(std::int64_t{box.end} - 1 - at.middle.y) {}
        std::int64_t left, right, low, high;
    };
    // Whether a chord of the ellipse does not reach the box, as most do not.
    static bool misses(const EllipseAt& at, const Box& box) {
        const auto [left, right, low, high] = Offsets(at, box);
        return portable::misses(at.ellipse, left, low, high) ||
               portable::misses(at.ellipse, right, low, high);
    }
    // Whether its chord covers the box: the ellipse holds all corners. Not told of narrow boxes.
    static bool covers(const EllipseAt& at, const Box& box) {
        const auto [left, right, low, high] = Offsets(at, box);
        return left != right && portable::holds_with_slack(at.ellipse, left, low) &&
               portable::holds_with_slack(at.ellipse, right, high) &&
               portable::holds_with_slack(at.ellipse, left, high) &&
               portable::holds_with_slack(at.ellipse, right, low);
    }

    // Writes the chord of the k-th sample after the first `count` chords, and returns how many
    // there are then; kAll if it covers the box.
    std::size_t add_ellipse_chord(const Box& box, const portable::Ellipse& of_box, std::size_t k,
                                  std::size_t count) {
        const Plan& plan = state_.plan;
        const Sized sample = near_[k];
        const portable::Interval chord = portable::ellipse_chord(
            sample.x, near_ellipses_[k], box.x, box.width, of_box, wraps_ ? plan.period_x : 0);
        if (chord.begin >= chord.end) return count;
        const auto y = std::int64_t{sample.y};
        for (std::uint32_t window = 0; window < (wraps_ ? 3U : 1U); ++window) {
            const Span there{portable::height_in_window(window, y + chord.begin, plan.height),
                             portable::height_in_window(window, y + chord.end, plan.height)};
            if (there.begin <= box.begin && there.end >= box.end) return Vectors::kAll;
            if (there.begin < there.end) chords_[count++] = there;
        }
        return count;
    }

    // Appends the pieces between the first `count` chords.
    void append_pieces(const Box& box, std::size_t count) {
        const std::span<Span> chords = std::span(chords_).first(count);
        insertion_sort(chords, [](Span a, Span b) { return a.begin < b.begin; });
        for_each_piece({box.begin, box.end}, chords, [&](std::uint32_t begin, std::uint32_t end) {
            left_.push_back({{box.x, box.width, begin, end}, block_});
        });
    }

    // The chords where samples may be nearer across an edge of the torus.
    std::size_t find_chords_around(const Box& box, std::uint32_t radius) {
        const Plan& plan = state_.plan;
        const std::uint32_t half = box.width / 2;
        std::size_t count = 0;
        for (std::size_t i = 0; i < near_.count; ++i) {
            const Sized sample = near_[i];
            const std::uint64_t least = std::min(radius, sample.radius);
            const std::uint32_t dx =
                portable::axis_distance(sample.x, box.x + half, plan.period_x) + half;
            const std::uint32_t reach = portable::chord_reach(dx, least * least);
            for (std::uint32_t window = 0; reach != 0 && window < 3; ++window) {
                const Span chord{portable::window_begin(window, sample.y, reach, plan.height),
                                 portable::window_end(window, sample.y, reach, plan.height)};
                if (chord.begin >= chord.end) continue;
                if (chord.begin <= box.begin && chord.end >= box.end) return Vectors::kAll;
                chords_[count++] = chord;
            }
        }
        return count;
    }

    void batch(const Box& box) {
        batch_[batched_++] = box;
        if (batched_ == batch_.size()) append_batch();
    }

    // find_touching tests eight boxes in less time than the chords of one box take. Most boxes are
    // untouched or covered by one sample; few are touched by several. Where the radius varies,
    // kAnyRadius finds all samples that may touch; their chords have the least radius under the
    // box.
    void append_batch() {
        const bool is_even = even_radius_ != 0;
        touching_.resize(std::max(touching_.size(), near_.count));
        touched_by_.resize(std::max(touched_by_.size(), near_.count));
        const unsigned covered = vectors_.find_touching(
            near_, batch_.data(), is_even ? own_radius(even_radius_) : kAnyRadius,
            touching_.data());
        const bool is_told = is_even && !has_ellipses_;  // which boxes are covered
        const unsigned left = ((1U << batched_) - 1) & (is_told ? ~covered : ~0U);
        std::array<std::size_t, Vectors::kBoxes> counts{};
        for (std::size_t k = 0; k < near_.count; ++k)
            for (unsigned bits = touching_[k] & left; bits != 0; bits &= bits - 1) {
                const auto i = static_cast<std::size_t>(std::countr_zero(bits));
                touched_by_[counts[i]++][i] = static_cast<std::uint32_t>(k);
            }
        for (unsigned bits = left; bits != 0; bits &= bits - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(bits));
            if (counts[i] == 0)
                left_.push_back({batch_[i], block_});
            else
                append_touched(i, counts[i]);
        }
        batched_ = 0;
    }

    void append_touched(std::size_t i, std::size_t samples) {
        const Box& box = batch_[i];
        if (has_ellipses_)
            return append_with_ellipses(box, samples,
                                        [&](std::size_t k) { return touched_by_[k][i]; });
        const std::uint32_t radius = own_radius(least_under(box));
        const std::uint32_t half = box.width / 2;
        chords_.resize(std::max(chords_.size(), samples));
        std::size_t count = 0;
        for (std::size_t k = 0; k < samples; ++k) {
            const Sized sample = near_[touched_by_[k][i]];
            const std::uint64_t least = std::min(radius, sample.radius);
            const std::uint32_t dx = portable::axis_distance(sample.x, box.x + half, 0) + half;
            const std::uint32_t reach = portable::chord_reach(dx, least * least);
            if (reach != 0)
                chords_[count++] = {sample.y + 1 - std::min(sample.y + 1, reach), sample.y + reach};
        }
        append_pieces(box, count);
    }

    static std::uint32_t middle_of(const Box& box) {
        return box.width > 1 ? box.x + box.width / 2 : 0;
    }

    // Cuts only along borders of pixels.
    void append_parts(const Box& box) {
        const std::uint32_t cut = even_radius_ != 0 ? 0 : state_.radius_field.cut_y(box);
        if (cut == 0) return append_part(box);
        append_part({box.x, box.width, box.begin, cut});
        append_part({box.x, box.width, cut, box.end});
    }

    // Drops the part if no sample may lie there.
    void append_part(const Box& box) {
        if (const std::uint32_t radius = least_under(box); radius != 0) append(box, radius);
    }

    const FieldState& state_;
    const Sheets& sheets_;
    const bool has_classes_ = sheets_.are_several();
    const bool has_ellipses_ = state_.radius_field.has_ellipses();
    const Vectors& vectors_ = *all_vectors().front();
    bool is_at_edge_;  // the region lies at an edge of a torus
    std::vector<FieldState::BlockBox>& left_;
    std::uint32_t block_ = 0;
    std::uint32_t sheet_ = 0;
    SizedSpan all_near_{};  // as listed
    SizedSpan near_{};      // with classes, as the sheet sees them
    SizedList seen_;
    std::vector<portable::Ellipse> near_ellipses_;  // of near_, where there are any
    std::vector<std::size_t> reaching_;             // samples whose chords may reach a box
    std::uint32_t even_radius_ = 0;                 // 0 where the radius varies in the block
    bool wraps_ = false;
    std::vector<Span> chords_;  // has room for the chords of all samples
    std::array<Box, Vectors::kBoxes> batch_{};
    std::size_t batched_ = 0;
    std::vector<std::uint8_t> touching_;  // of each sample, a bit for each box of the batch
    std::vector<std::array<std::uint32_t, Vectors::kBoxes>> touched_by_;  // [k-th sample][box]
};

}  // namespace lacuna::cpu
