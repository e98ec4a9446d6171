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
#include "backends/cpu/near_ellipses.h"
#include "backends/cpu/neighbour_lists.h"
#include "base/insertion_sort.h"
#include "portable/chord.h"
#include "portable/conflict.h"
#include "portable/distance.h"

namespace lacuna::cpu {

class FieldCut {
public:
    FieldCut(const NeighbourLists& lists, std::vector<BlockBox>& left)
        : plan_(lists.plan()),
          first_(lists.first()),
          radius_field_(lists.radius_field()),
          sheets_(plan_.field().sheets),
          left_(left) {}

    // Boxes that are appended from here on are parts of this block.
    void begin(std::uint32_t block) {
        block_ = block;
        even_radius_ = first_.blocks[block].even_radius;
        wraps_ = wraps(first_.blocks[block].node);
        const Box& all = first_.nodes[first_.blocks[block].node].box;
        sheet_ = sheets_.of(all.x);
        if (has_ellipses_ && even_radius_ != 0)
            ellipses_.set_boxes(radius_field_.ellipse_at(all.x, all.begin));
    }
    // Boxes that are appended from here on are cut by these samples.
    void cut_by(const SizedSpan& near) {
        near_ = all_near_ = near;
        if (has_classes_ && even_radius_ != 0) see_with(even_radius_);
        if (has_ellipses_) ellipses_.set_samples(near);
    }

    void append_halves(const Box& box) {
        const std::uint32_t cut = even_radius_ != 0 ? middle_of(box) : radius_field_.cut_x(box);
        if (cut == 0) return append_parts(box);
        append_parts({box.x, cut - box.x, box.begin, box.end});
        append_parts({cut, box.x + box.width - cut, box.begin, box.end});
    }
    void append(const Box& box) { append(box, under(box)); }
    // Call it after the last box that these samples cut.
    void finish() {
        if (batched_ != 0) append_batch();
    }

    // Appends the pieces of all boxes of the block, or of their halves.
    void append_all(std::span<const BlockBox> boxes, bool halve) {
        for (const BlockBox& box : boxes) {
            if (has_ellipses_) {
                halve ? append_halves(box.at) : append(box.at);
                continue;
            }
            const std::uint32_t cut = halve ? middle_of(box.at) : 0;
            if (cut == 0) {
                batch(box.at);
                continue;
            }
            const auto& [x, width, begin, end] = box.at;
            batch({x, cut - x, begin, end});
            batch({cut, x + width - cut, begin, end});
        }
        finish();
    }
    // Whether append_all can be called for the block.
    bool can_append_all(bool halve) const {
        return !wraps_ && (has_ellipses_ || (!halve && !has_classes_) || even_radius_ != 0);
    }

private:
    Under under(const Box& box) const {
        return even_radius_ != 0 ? Under{even_radius_, even_radius_, true}
                                 : radius_field_.under(box);
    }

    // Whether the nearest way from a sample to a box in the node may cross an edge of the torus.
    bool wraps(std::uint32_t node) const {
        if (plan_.period_x == 0) return false;
        const auto& [box, greatest, next, first, whole] = first_.nodes[node];
        const std::uint32_t x = sheets_.x_on_sheet(box.x);
        const std::uint32_t most =
            portable::times_factor(greatest, sheets_.greatest_factor(sheets_.of(box.x)));
        return x < most || plan_.width - (x + box.width) < most || box.begin < most ||
               plan_.height - box.end < most;
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
    void append(const Box& box, const Under& under) {
        if (has_ellipses_) return append_with_ellipses(box, under);
        const std::uint32_t least = under.least;
        if (has_classes_ && even_radius_ == 0) see_with(least);
        const std::uint32_t radius = own_radius(least);
        chords_.resize(std::max(chords_.size(), 3 * near_.count + kVectorPadding));
        const std::size_t count =
            wraps_ ? find_chords_around(box, radius)
                   : vectors_.find_sized_chords(near_, box, radius, chords_.data());
        if (count != Vectors::kAll) append_pieces(box, count);
    }

    // The same with ellipses. A box where no sample may lie stays whole until it is halved.
    void append_with_ellipses(const Box& box, const Under& under) {
        if (under.least == 0) {
            finish();
            return left_.push_back({box, block_});
        }
        if (even_radius_ == 0) ellipses_.set_box(batched_, radius_field_.ellipse_under(box, under));
        if (!wraps_) return batch(box);
        append_cut(box, batched_, near_.count, [](std::size_t k) { return k; });
    }
    // Cuts the box, which is the i-th of the batch, by the ellipses of the samples number_of(0) to
    // number_of(samples - 1).
    template <typename NumberOf>
    void append_cut(const Box& box, std::size_t i, std::size_t samples, NumberOf number_of) {
        chords_.resize(std::max(chords_.size(), 3 * samples));
        std::size_t count = 0;
        for (std::size_t k = 0; k < samples; ++k) {
            count = ellipses_.add_chord(number_of(k), box, i, wraps_, chords_.data(), count);
            if (count == Vectors::kAll) return;
        }
        append_pieces(box, count);
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
        const std::uint32_t half = box.width / 2;
        std::size_t count = 0;
        for (std::size_t i = 0; i < near_.count; ++i) {
            const Sized sample = near_[i];
            const std::uint64_t least = std::min(radius, sample.radius);
            const std::uint32_t dx =
                portable::axis_distance(sample.x, box.x + half, plan_.period_x) + half;
            const std::uint32_t reach = portable::chord_reach(dx, least * least);
            for (std::uint32_t window = 0; reach != 0 && window < 3; ++window) {
                const Span chord{portable::window_begin(window, sample.y, reach, plan_.height),
                                 portable::window_end(window, sample.y, reach, plan_.height)};
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
        const unsigned covered =
            has_ellipses_ ? ellipses_.find_touching(vectors_, batch_.data(), touching_.data())
                          : vectors_.find_touching(near_, batch_.data(),
                                                   is_even ? own_radius(even_radius_) : kAnyRadius,
                                                   touching_.data());
        const bool is_told = is_even || has_ellipses_;  // which boxes are covered
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
            return append_cut(box, i, samples, [&](std::size_t k) { return touched_by_[k][i]; });
        const std::uint32_t radius = own_radius(under(box).least);
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
        const std::uint32_t cut = even_radius_ != 0 ? 0 : radius_field_.cut_y(box);
        if (cut == 0) return append_part(box);
        append_part({box.x, box.width, box.begin, cut});
        append_part({box.x, box.width, cut, box.end});
    }

    // Drops the part if no sample may lie there.
    void append_part(const Box& box) {
        if (const Under found = under(box); found.least != 0) append(box, found);
    }

    const Plan& plan_;
    const FirstBoxes& first_;
    const RadiusField& radius_field_;
    const Sheets& sheets_;
    const bool has_classes_ = sheets_.are_several();
    const bool has_ellipses_ = radius_field_.has_ellipses();
    const Vectors& vectors_ = *all_vectors().front();
    std::vector<BlockBox>& left_;
    std::uint32_t block_ = 0;
    std::uint32_t sheet_ = 0;
    SizedSpan all_near_{};  // as listed
    SizedSpan near_{};      // with classes, as the sheet sees them
    SizedList seen_;
    NearEllipses ellipses_{plan_};
    std::uint32_t even_radius_ = 0;  // 0 where the radius varies in the block
    bool wraps_ = false;
    std::vector<Span> chords_;  // has room for the chords of all samples
    std::array<Box, Vectors::kBoxes> batch_{};
    std::size_t batched_ = 0;
    std::vector<std::uint8_t> touching_;  // of each sample, a bit for each box of the batch
    std::vector<std::array<std::uint32_t, Vectors::kBoxes>> touched_by_;  // [k-th sample][box]
};

}  // namespace lacuna::cpu
