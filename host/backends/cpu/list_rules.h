// The rules of samples with a radius field, which the neighbour lists find: radii, classes and
// ellipses.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "backends/cpu/box_cutter.h"
#include "backends/cpu/neighbour_lists.h"
#include "backends/cpu/vectors.h"
#include "portable/conflict.h"

namespace lacuna::cpu {

// What these rules have in common: boxes are cut block by block.
class ListRule {
public:
    using Active = BlockBox;
    static constexpr bool kIsBatched = true;
    static constexpr std::size_t kAhead = 8;  // prefetch distance, in boxes

    ListRule(NeighbourLists& lists, bool halve)
        : field_(lists.radius_field()), lists_(lists), halve_(halve) {}
    const Plan& plan() const { return lists_.plan(); }

    // The number of boxes of the first one's block.
    std::size_t group_size(std::span<const BlockBox> boxes) const {
        std::size_t size = 1;
        while (size < boxes.size() && boxes[size].block == boxes.front().block) ++size;
        return size;
    }
    void fetch(const BlockBox& later) const {
        if (halve_ || lists_.has_latest(later.block)) lists_.fetch_list(later.block);
    }
    // Boxes that are not halved are cut only by samples that have not cut them yet.
    bool begin(const BlockBox& box) {
        block_ = box.block;
        const auto& [first, even_radius, node, least] = lists_.first().blocks[block_];
        even_radius_ = even_radius;
        wraps_ = may_wrap(node);
        return halve_ || lists_.has_latest(block_);
    }
    // The parts of a long list that has been split serve a batch of boxes each.
    std::size_t find_near(std::span<const BlockBox> boxes) {
        Box all = boxes.front().at;
        std::size_t count = boxes.size();
        if (lists_.is_split(block_)) {
            count = std::min(count, BoxBatch::kBoxes);
            for (const BlockBox& box : boxes.first(count)) all = bounds_of(all, box.at);
        }
        near_ = lists_.of_part(block_, all,
                               halve_ ? NeighbourLists::Which::all : NeighbourLists::Which::latest,
                               scratch_);
        bits_.resize(std::max(bits_.size(), near_.count));
        return count;
    }
    void end(bool is_gone) {
        lists_.note_cuts(block_);
        if (is_gone) lists_.close(block_);
    }
    std::size_t near_count() const { return near_.count; }

    // Halves are cut along borders of pixels where the box lies on unlike pixels. A half is left
    // out if no sample may lie there.
    template <typename Visit>
    void for_each_part(const BlockBox& active, Visit visit) {
        const Box& box = active.at;
        under_ = {even_radius_, even_radius_, true};
        if (even_radius_ == 0 && halve_) {
            under_ = field_.under(box);
            if (under_.least == 0) return;
            if (under_.is_even) return cut_at(box, middle_of(box), visit);
            return cut_at(box, field_.cut_x(box), [&](const Box& side) {
                const std::uint32_t y = field_.cut_y(side);
                if (y == 0) return visit_allowed(side, visit);
                visit_allowed({side.x, side.width, side.begin, y}, visit);
                visit_allowed({side.x, side.width, y, side.end}, visit);
            });
        }
        if (even_radius_ == 0) under_ = kUnread;
        cut_at(box, halve_ ? middle_of(box) : 0, visit);
    }
    BlockBox active(const Box& box) const { return {box, block_}; }
    bool wraps(const Box&) const { return wraps_; }

protected:
    // Stands for what lies under a box that is not halved. Few of these are touched by a sample.
    static constexpr Under kUnread{kAnyRadius, kAnyRadius, false};

    // Adds each sample to those of the first `boxes` boxes that it touches by its bits in bits_,
    // except the boxes that are covered.
    unsigned add_touching(Touching& touching, std::size_t boxes, unsigned covered) const {
        const unsigned open = ((1U << boxes) - 1) & ~covered;
        for (std::size_t k = 0; k < near_.count; ++k) touching.add(k, bits_[k] & open);
        return covered;
    }
    std::uint32_t period_x() const { return wraps_ ? plan().period_x : 0; }

    const RadiusField& field_;
    const Vectors& vectors_ = *all_vectors().front();
    SizedSpan near_{};
    std::vector<std::uint8_t> bits_;  // of each sample, a bit for each box of a batch
    std::uint32_t even_radius_ = 0;   // 0 where the radius varies in the block
    bool wraps_ = false;              // whether a sample may be nearer across an edge of the torus
    Under under_{};                   // the part that is visited

private:
    // Whether the nearest way from a sample to a box in the node may cross an edge of the torus.
    bool may_wrap(std::uint32_t node) const {
        if (plan().period_x == 0) return false;
        const ClassCopies& copies = plan().field().copies;
        const auto& [box, greatest, next, first, whole] = lists_.first().nodes[node];
        const std::uint32_t x = copies.x_on_copy(box.x);
        const std::uint32_t most =
            portable::times_factor(greatest, copies.greatest_factor(copies.of(box.x)));
        return x < most || plan().width - (x + box.width) < most || box.begin < most ||
               plan().height - box.end < most;
    }
    static Box bounds_of(const Box& a, const Box& b) {
        const std::uint32_t x = std::min(a.x, b.x);
        return {x, std::max(a.x + a.width, b.x + b.width) - x, std::min(a.begin, b.begin),
                std::max(a.end, b.end)};
    }
    // Where an even box is halved; 0 if it is too narrow.
    static std::uint32_t middle_of(const Box& box) {
        return box.width > 1 ? box.x + box.width / 2 : 0;
    }
    // Visits both sides of a cut at `x`, or the whole box if this is 0.
    template <typename Visit>
    static void cut_at(const Box& box, std::uint32_t x, Visit visit) {
        if (x == 0) return visit(box);
        visit(Box{box.x, x - box.x, box.begin, box.end});
        visit(Box{x, box.x + box.width - x, box.begin, box.end});
    }
    template <typename Visit>
    void visit_allowed(const Box& part, Visit visit) {
        under_ = field_.under(part);
        if (under_.least != 0) visit(part);
    }

    NeighbourLists& lists_;
    SizedList scratch_;
    bool halve_;
    std::uint32_t block_ = 0;
};

// Two samples keep the smaller of their radii.
class Radii : public ListRule {
public:
    using ListRule::ListRule;

    void set(std::size_t i, const Box&) { radii_[i] = under_.least; }
    unsigned find_touching(const BoxBatch& boxes, std::size_t count, Touching& touching) {
        return find_touching(boxes, count, near_, radii_, under_.least != kAnyRadius, touching);
    }
    portable::Interval chord(std::size_t k, std::size_t i, const Box& box) {
        const auto [x, y, radius] = near_[k];
        return disk_chord({x, y}, portable::squared_limit(radius, radius_of(i, box), FACTOR_ONE),
                          box, period_x());
    }

protected:
    using RadiiOfBoxes = std::array<std::uint32_t, BoxBatch::kBoxes>;

    // If the radii are too large, more samples touch a box, and none is said to cover it.
    unsigned find_touching(const BoxBatch& boxes, std::size_t count, const SizedSpan& samples,
                           const RadiiOfBoxes& radii, bool are_exact, Touching& touching) {
        if (wraps_) return 0;
        const unsigned covered = vectors_.find_touching(samples, boxes, radii.data(), bits_.data());
        return add_touching(touching, count, are_exact ? covered : 0);
    }
    std::uint32_t radius_of(std::size_t i, const Box& box) {
        if (radii_[i] == kAnyRadius) radii_[i] = field_.under(box).least;
        return radii_[i];
    }

    RadiiOfBoxes radii_{};
};

// Two classes keep their factor times the smaller radius.
class Classes : public Radii {
public:
    using Radii::Radii;

    std::size_t find_near(std::span<const BlockBox> boxes) {
        const std::size_t count = ListRule::find_near(boxes);
        copy_ = copies_.of(boxes.front().at.x);
        seen_.see(copies_, copy_, near_, even_radius_ != 0 ? even_radius_ : kAnyRadius);
        return count;
    }
    unsigned find_touching(const BoxBatch& boxes, std::size_t count, Touching& touching) {
        constexpr RadiiOfBoxes kAny{kAnyRadius, kAnyRadius, kAnyRadius, kAnyRadius,
                                    kAnyRadius, kAnyRadius, kAnyRadius, kAnyRadius};
        return Radii::find_touching(boxes, count, seen_.span(), kAny, even_radius_ != 0, touching);
    }
    portable::Interval chord(std::size_t k, std::size_t i, const Box& box) {
        const Sized seen = seen_.span()[k];
        std::uint64_t limit = seen.radius;
        if (even_radius_ == 0)
            limit = portable::times_factor(std::min(near_.radius[k], radius_of(i, box)),
                                           copies_.factor(copy_, copies_.of(near_.x[k])));
        return disk_chord({seen.x, seen.y}, limit * limit, box, period_x());
    }

private:
    const ClassCopies& copies_ = plan().field().copies;
    std::uint32_t copy_ = 0;  // of the block
    SizedList seen_;          // the samples as the copy sees them
};

// Two samples conflict if each lies in the other's ellipse. Single precision decides most boxes;
// for the rest, whole numbers decide.
class Ellipses : public ListRule {
public:
    using ListRule::ListRule;

    std::size_t find_near(std::span<const BlockBox> boxes) {
        const std::size_t count = ListRule::find_near(boxes);
        of_samples_.clear();
        in_floats_.clear();
        for (std::size_t k = 0; k < near_.count; ++k) {
            of_samples_.push_back(field_.ellipse_at(near_.x[k], near_.y[k]));
            in_floats_.push_back(in_floats(of_samples_.back()));
        }
        if (even_radius_ != 0) {
            of_boxes_.fill(field_.ellipse_at(boxes.front().at.x, boxes.front().at.begin));
            boxes_in_floats_.fill(in_floats(of_boxes_.front()));
        }
        return count;
    }
    void set(std::size_t i, const Box& box) {
        whole_ &= ~(1U << i);
        if (even_radius_ != 0) return;
        Under under = under_.least == kAnyRadius ? field_.under(box) : under_;
        whole_ |= unsigned{under.least == 0} << i;
        under.least = std::max(under.least, 1U);  // circles have no radius of 0
        of_boxes_[i] = field_.ellipse_under(box, under);
        boxes_in_floats_[i] = in_floats(of_boxes_[i]);
    }
    unsigned find_touching(const BoxBatch& boxes, std::size_t count, Touching& touching) {
        if (wraps_) return 0;
        const unsigned covered = vectors_.find_touching_ellipses(
            near_, in_floats_.data(), boxes, boxes_in_floats_.data(), bits_.data());
        return add_touching(touching, count, covered & ~whole_);
    }
    portable::Interval chord(std::size_t k, std::size_t i, const Box& box) const {
        if ((whole_ >> i & 1) != 0) return {0, 0};
        const auto [begin, end] = portable::ellipse_chord(near_.x[k], of_samples_[k], box.x,
                                                          box.width, of_boxes_[i], period_x());
        return {near_.y[k] + begin, near_.y[k] + end};
    }

private:
    std::vector<portable::Ellipse> of_samples_;
    std::vector<FloatEllipse> in_floats_;
    std::array<portable::Ellipse, BoxBatch::kBoxes> of_boxes_{};
    std::array<FloatEllipse, BoxBatch::kBoxes> boxes_in_floats_{};
    // A bit for each box where the mask forbids some place: nothing is cut from it until it is
    // halved.
    unsigned whole_ = 0;
};

}  // namespace lacuna::cpu
