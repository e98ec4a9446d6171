// Mode exact: bins that hold all of the free space, candidates that count only where they are truly
// free, and ever finer boxes until no box is left (docs/design.md, section 4). With a radius field
// only the data differ: the plan gives the first boxes, and each box has the least radius under it.
#include <algorithm>
#include <bit>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "backends/reference/free_space.h"
#include "backends/reference/lines.h"
#include "base/polling.h"
#include "plan/first_boxes.h"
#include "plan/radius_field.h"
#include "portable/conflict.h"

namespace lacuna::reference {
namespace {

// A sample as one copy sees it (plan/class_copies.h): its x lies on the domain, and the factor is
// that of its class and the copy's.
struct Neighbour {
    Sized sized;
    std::uint64_t factor;
};

// All samples that one copy sees, in a grid of square cells, called bins, for each magnitude of
// the distance that they keep. Distances of one magnitude differ by less than a factor of 2, and
// its bins are wider than all of them. So everything within that distance of a point lies in the
// point's own bin or in one beside it.
class Samples {
public:
    explicit Samples(const Plan& plan) : plan_(&plan), magnitudes_(kMagnitudes) {}

    void add(const Neighbour& sample) {
        ask_after();
        const auto& [x, y, radius] = sample.sized;
        const std::uint32_t reach = portable::times_factor(radius, sample.factor);
        const auto index = static_cast<unsigned>(std::bit_width(reach));
        magnitudes_[index][{bin_of(x, index), bin_of(y, index)}].push_back(sample);
    }

    // Visits every sample that could be closer to the box than the distance that it keeps, and
    // others, until visit(sample) returns false. Returns whether it always returned true. The box
    // lies on the domain.
    template <typename Visit>
    bool for_each_near(const Box& box, Visit visit) const {
        ask_after();
        for (unsigned index = 0; index < kMagnitudes; ++index) {
            if (magnitudes_[index].empty()) continue;
            const std::int64_t reach = std::int64_t{1} << index;
            for (const auto& x :
                 stretches(std::int64_t{box.x} - reach, std::int64_t{box.x} + box.width + reach,
                           plan_->width, plan_->period_x))
                for (const auto& y :
                     stretches(std::int64_t{box.begin} - reach, std::int64_t{box.end} + reach,
                               plan_->height, plan_->period_y))
                    if (!visit_bins(index, x, y, visit)) return false;
        }
        return true;
    }

private:
    static constexpr unsigned kMagnitudes = 33;  // a distance, of 32 bits, has 0 to 32 bits

    static std::uint32_t bin_of(std::uint32_t at, unsigned index) {
        return static_cast<std::uint32_t>(std::uint64_t{at} >> index);
    }

    using Bins = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Neighbour>>;

    // The parts of [begin, end) on an axis; on a torus the parts beyond its ends wrap around.
    static std::vector<Span> stretches(std::int64_t begin, std::int64_t end, std::uint32_t length,
                                       std::uint32_t period) {
        std::vector<Span> found;
        const auto add = [&](std::int64_t low, std::int64_t high) {
            const std::int64_t cut_low = std::max<std::int64_t>(low, 0);
            const std::int64_t cut_high = std::min<std::int64_t>(high, length);
            if (cut_low < cut_high)
                found.push_back(
                    {static_cast<std::uint32_t>(cut_low), static_cast<std::uint32_t>(cut_high)});
        };
        if (period != 0 && end - begin >= length) return {{0, length}};
        add(begin, end);
        if (period != 0) add(begin + length, end + length);
        if (period != 0) add(begin - length, end - length);
        return found;
    }

    template <typename Visit>
    bool visit_bins(unsigned index, Span x, Span y, Visit& visit) const {
        const Bins& bins = magnitudes_[index];
        const std::uint32_t low = bin_of(y.begin, index);
        const std::uint32_t high = bin_of(y.end - 1, index);
        for (std::uint32_t i = bin_of(x.begin, index); i <= bin_of(x.end - 1, index); ++i)
            for (auto bin = bins.lower_bound({i, low});
                 bin != bins.end() && bin->first <= std::pair(i, high); ++bin)
                for (const Neighbour& sample : bin->second) {
                    ask_after();
                    if (!visit(sample)) return false;
                }
        return true;
    }

    const Plan* plan_;
    std::vector<Bins> magnitudes_;  // by the number of bits of a distance
};

// Lines with free spans at first, boxes after the first cut. With a radius field there are
// boxes from the start.
class Exact : public FreeSpace {
public:
    explicit Exact(const Plan& plan)
        : plan_(plan),
          field_(plan.has_radius_field() ? plan.field().radius_field.get() : nullptr),
          copies_(plan.has_radius_field() ? plan.field().copies : ClassCopies()),
          samples_(copies_.count(), Samples(plan)),
          recent_(samples_),
          spans_(plan),
          width_(plan.strip_width) {
        if (field_ == nullptr) return;
        for (const Sized& kept : plan.field().kept) add(kept);
        set_boxes(plan.field().first_boxes->boxes);
    }

    std::span<const std::uint32_t> free_lengths() const override {
        return are_boxes_ ? lengths_ : spans_.lengths();
    }
    std::uint32_t bin_width() const override { return width_; }
    std::span<const std::uint32_t> bin_widths() const override { return widths_; }
    Sample at(std::uint32_t bin, std::uint32_t rank, std::uint32_t offset) const override {
        if (are_boxes_) return {boxes_[bin].x + offset, boxes_[bin].begin + rank};
        return {bin * plan_.strip_width + offset, spans_.y_at_rank(bin, rank)};
    }

    bool is_free(Sample candidate) const override {
        const Sized sized{copies_.x_on_copy(candidate.x), candidate.y, radius_at(candidate)};
        if (sized.radius == 0) return false;
        return samples_[copies_.of(candidate.x)].for_each_near(
            {sized.x, 1, sized.y, sized.y + 1}, [&](const Neighbour& near) {
                return has_ellipses() ? !portable::ellipses_conflict(
                                            near.sized, ellipse_of(near.sized), sized,
                                            ellipse_of(sized), plan_.period_x, plan_.period_y)
                                      : !portable::conflicts(near.sized, sized, near.factor,
                                                             plan_.period_x, plan_.period_y);
            });
    }
    void add(Sample sample) override { add(Sized{sample.x, sample.y, radius_at(sample)}); }

    // Either the round's samples cut the bins, or boxes are halved, and then all samples cut the
    // halves. Parts where no sample may lie are dropped.
    void end_round(std::span<const Sample> samples, const RoundPolicy& policy) override {
        if (policy.refines())
            refine(policy.halves());
        else
            for (const Sample sample : samples) spans_.subtract_disk(sample);
        recent_.assign(copies_.count(), Samples(plan_));
    }

private:
    // Each copy sees the sample with the factor of both classes, and not at all if that is 0.
    void add(const Sized& sample) {
        const Sized on_domain{copies_.x_on_copy(sample.x), sample.y, sample.radius};
        for (std::uint32_t copy = 0; copy < copies_.count(); ++copy) {
            const Neighbour seen{on_domain, copies_.factor(copies_.of(sample.x), copy)};
            if (seen.factor == 0) continue;
            samples_[copy].add(seen);
            recent_[copy].add(seen);
        }
    }

    std::uint32_t radius_at(Sample at) const {
        return field_ == nullptr ? plan_.radius : field_->radius_at(at.x, at.y);
    }
    bool has_ellipses() const { return field_ != nullptr && field_->has_ellipses(); }
    const portable::Ellipse& ellipse_of(const Sized& sample) const {
        return field_->ellipse_at(sample.x, sample.y);
    }
    std::uint32_t least_under(const Box& box) const {
        return field_ == nullptr ? plan_.radius : field_->under(box).least;
    }

    void refine(bool halve) {
        std::vector<Box> left;
        for (const Box& box : are_boxes_ ? std::exchange(boxes_, {}) : boxes_of_lines()) {
            if (!halve) {
                append_pieces(box, recent_, left);
                continue;
            }
            for (const Box& half : halves_along_x(box))
                for (const Box& part : parts_along_y(half))
                    if (least_under(part) != 0) append_pieces(part, samples_, left);
        }
        if (halve) width_ /= 2;
        set_boxes(std::move(left));
    }

    void set_boxes(std::vector<Box> boxes) {
        boxes_ = std::move(boxes);
        are_boxes_ = true;
        lengths_.clear();
        widths_.clear();
        for (const Box& box : boxes_) {
            lengths_.push_back(box.end - box.begin);
            if (field_ != nullptr) widths_.push_back(box.width);
        }
    }

    // Free spans as boxes, which end where a row of the sample grid does.
    std::vector<Box> boxes_of_lines() const {
        std::vector<Box> all;
        const std::uint32_t side = plan_.grid().side;
        for (std::uint32_t line = 0; line < plan_.lines; ++line) {
            for (const Span span : spans_.of_line(line)) {
                for (std::uint32_t begin = span.begin; begin < span.end;) {
                    const std::uint32_t end = std::min(span.end, begin - begin % side + side);
                    all.push_back({line * width_, width_, begin, end});
                    begin = end;
                }
            }
        }
        return all;
    }

    // A box that lies on unlike pixels is cut along their borders, others in the middle.
    std::vector<Box> halves_along_x(const Box& box) const {
        const std::uint32_t cut = field_ == nullptr ? box.x + box.width / 2 : field_->cut_x(box);
        if (cut == 0) return {box};
        return {{box.x, cut - box.x, box.begin, box.end},
                {cut, box.x + box.width - cut, box.begin, box.end}};
    }
    // Cuts only along borders of unlike pixels.
    std::vector<Box> parts_along_y(const Box& box) const {
        const std::uint32_t cut = field_ == nullptr ? 0 : field_->cut_y(box);
        if (cut == 0) return {box};
        return {{box.x, box.width, box.begin, cut}, {box.x, box.width, cut, box.end}};
    }

    // With ellipses. The sample conflicts with every point of the box on the chord.
    void append_chord(const Box& box, const Sized& near, std::vector<Span>& chords) const {
        const portable::Interval chord =
            portable::ellipse_chord(near.x, ellipse_of(near), box.x, box.width,
                                    field_->ellipse_under(box, field_->under(box)), plan_.period_x);
        const auto y = std::int64_t{near.y};
        for (std::uint32_t window = 0; window < (plan_.period_y == 0 ? 1U : 3U); ++window)
            if (chord.begin < chord.end)
                chords.push_back({portable::height_in_window(window, y + chord.begin, plan_.height),
                                  portable::height_in_window(window, y + chord.end, plan_.height)});
    }

    // Appends the pieces of the box after the samples' chords are cut from it. A chord covers the
    // box's whole width: it is cut at the far edge. Its radius is the smaller of the sample's and
    // the least one under the box, so that the sample conflicts with every point in it.
    void append_pieces(const Box& box, const std::vector<Samples>& samples,
                       std::vector<Box>& left) const {
        const std::uint32_t radius = least_under(box);
        const std::uint32_t half = box.width / 2;
        const std::uint32_t x = copies_.x_on_copy(box.x);
        std::vector<Span> chords;
        const auto covers = [&](Span chord) {
            return chord.begin <= box.begin && chord.end >= box.end;
        };
        const bool is_open = samples[copies_.of(box.x)].for_each_near(
            {x, box.width, box.begin, box.end}, [&](const Neighbour& near) {
                if (has_ellipses() && radius != 0) append_chord(box, near.sized, chords);
                if (has_ellipses()) return true;
                const std::uint32_t dx =
                    portable::axis_distance(near.sized.x, x + half, plan_.period_x) + half;
                for_each_window(plan_, near.sized.y,
                                portable::chord(near.sized, dx, radius, near.factor),
                                [&](Span chord) { chords.push_back(chord); });
                return chords.empty() || !covers(chords.back());
            });
        if (!is_open) return;
        chords.push_back({box.end, box.end});
        std::sort(chords.begin(), chords.end(), [](Span a, Span b) { return a.begin < b.begin; });
        std::uint32_t free_from = box.begin;
        for (const Span chord : chords) {
            const std::uint32_t free_to = std::min(chord.begin, box.end);
            if (free_from < free_to) left.push_back({box.x, box.width, free_from, free_to});
            free_from = std::max(free_from, chord.end);
        }
    }

    const Plan& plan_;
    const RadiusField* field_;  // null where there is one radius
    ClassCopies copies_;
    std::vector<Samples> samples_;  // of each copy
    std::vector<Samples> recent_;   // the samples that have not cut the bins yet
    FreeSpans spans_;
    std::vector<Box> boxes_;
    std::vector<std::uint32_t> lengths_;
    std::vector<std::uint32_t> widths_;  // empty where all are width_
    std::uint32_t width_;
    bool are_boxes_ = false;
};

}  // namespace

std::unique_ptr<FreeSpace> make_exact(const Plan& plan) {
    return std::make_unique<Exact>(plan);
}

}  // namespace lacuna::reference
