// Mode exact with a radius field: radii differ from pixel to pixel, and some pixels allow no sample
// (docs/design.md, section 4, "exact with a radius field"). Two samples keep the smaller of their
// radii apart.
#include <algorithm>
#include <bit>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "backends/backend.h"
#include "backends/reference/free_space.h"
#include "plan/first_boxes.h"
#include "plan/radius_field.h"
#include "portable/chord.h"
#include "portable/distance.h"

namespace lacuna::reference {
namespace {

struct Sized {
    Sample sample;
    std::uint32_t radius;
};

// All samples, with square bins for each class of radii. Radii of one class differ by less than a
// factor of 2, and its bins are wider than all of them. So everything within a sample's radius of a
// point lies in the point's own bin or in one beside it.
class SizedSamples {
public:
    explicit SizedSamples(const Plan& plan) : plan_(&plan), classes_(32) {}

    void add(const Sized& sized) {
        const auto& [sample, radius] = sized;
        const auto index = static_cast<unsigned>(std::bit_width(radius));
        classes_[index][{sample.x >> index, sample.y >> index}].push_back(sized);
    }

    // Visits every sample that could be closer to the box than its own radius, and others.
    template <typename Visit>
    void for_each_near(const Rectangle& place, Visit visit) const {
        for (unsigned index = 0; index < 32; ++index) {
            if (classes_[index].empty()) continue;
            const std::int64_t reach = std::int64_t{1} << index;
            for (const auto& x : stretches(std::int64_t{place.x} - reach,
                                           std::int64_t{place.x} + place.width + reach,
                                           plan_->width, plan_->period_x))
                for (const auto& y :
                     stretches(std::int64_t{place.begin} - reach, std::int64_t{place.end} + reach,
                               plan_->height, plan_->period_y))
                    visit_bins(index, x, y, visit);
        }
    }

private:
    using Bins = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Sized>>;

    // The parts of [begin, end) on an axis: what sticks out of a torus wraps around.
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
    void visit_bins(unsigned index, Span x, Span y, Visit& visit) const {
        const Bins& bins = classes_[index];
        for (std::uint32_t i = x.begin >> index; i <= (x.end - 1) >> index; ++i)
            for (auto bin = bins.lower_bound({i, y.begin >> index});
                 bin != bins.end() && bin->first <= std::pair(i, (y.end - 1) >> index); ++bin)
                for (const Sized& sized : bin->second) visit(sized);
    }

    const Plan* plan_;
    std::vector<Bins> classes_;  // by the number of bits of a radius
};

class ExactWithField : public FreeSpace {
public:
    explicit ExactWithField(const Plan& plan)
        : plan_(plan),
          radius_field_(*plan.radius_field),
          samples_(plan),
          recent_(plan),
          places_(plan.first_boxes->places) {
        for (const auto& [at, radius] : plan.kept) add(Sized{at, radius});
        measure_places();
    }

    std::span<const std::uint32_t> free_lengths() const override { return lengths_; }
    std::uint32_t bin_width() const override { return plan_.strip_width; }
    std::span<const std::uint32_t> bin_widths() const override { return widths_; }
    Sample at(std::uint32_t place, std::uint32_t rank, std::uint32_t offset) const override {
        return {places_[place].x + offset, places_[place].begin + rank};
    }

    bool is_free(Sample candidate) const override {
        const std::uint32_t radius = radius_field_.radius_at(candidate.x, candidate.y);
        if (radius == 0) return false;
        bool covered = false;
        const Rectangle place{candidate.x, 1, candidate.y, candidate.y + 1};
        samples_.for_each_near(place, [&](const Sized& near) {
            const std::uint64_t least = std::min(radius, near.radius);
            covered |= portable::are_closer(near.sample.x, near.sample.y, candidate.x, candidate.y,
                                            plan_.period_x, plan_.period_y, least * least);
        });
        return !covered;
    }
    void add(Sample sample) override {
        add(Sized{sample, radius_field_.radius_at(sample.x, sample.y)});
    }

    // Bins are boxes from the start. Either the round's samples cut them, or they are halved, and
    // then all samples cut the halves. Parts where no sample may lie are dropped.
    void end_round(std::span<const Sample>, const RoundPolicy& policy) override {
        const std::vector<Rectangle> old = std::exchange(places_, {});
        for (const Rectangle& place : old) {
            if (!policy.halves()) {
                append_remnants(place, recent_);
                continue;
            }
            for (const Rectangle& half : halves_along_x(place))
                for (const Rectangle& part : parts_along_y(half))
                    if (radius_field_.under(part).least != 0) append_remnants(part, samples_);
        }
        recent_ = SizedSamples(plan_);
        measure_places();
    }

private:
    void add(const Sized& sized) {
        samples_.add(sized);
        recent_.add(sized);
    }

    void measure_places() {
        lengths_.clear();
        widths_.clear();
        for (const Rectangle& place : places_) {
            lengths_.push_back(place.end - place.begin);
            widths_.push_back(place.width);
        }
    }

    std::vector<Rectangle> halves_along_x(const Rectangle& place) const {
        const std::uint32_t cut = radius_field_.cut_x(place);
        if (cut == 0) return {place};
        return {{place.x, cut - place.x, place.begin, place.end},
                {cut, place.x + place.width - cut, place.begin, place.end}};
    }
    // Cuts only along borders of unlike pixels.
    std::vector<Rectangle> parts_along_y(const Rectangle& place) const {
        const std::uint32_t cut = radius_field_.cut_y(place);
        if (cut == 0) return {place};
        return {{place.x, place.width, place.begin, cut}, {place.x, place.width, cut, place.end}};
    }

    // Appends the pieces of the box after the samples' chords are cut from it. A chord spans the
    // box's whole width. Its radius is the smaller of the sample's and the least one under the box,
    // so that the sample conflicts with every point in it.
    void append_remnants(const Rectangle& place, const SizedSamples& samples) {
        const Under under = radius_field_.under(place);
        std::vector<Span> chords;
        samples.for_each_near(place, [&](const Sized& near) {
            const std::uint64_t radius = std::min(under.least, near.radius);
            const std::uint32_t dx =
                portable::axis_distance(near.sample.x, place.x + place.width / 2, plan_.period_x) +
                place.width / 2;
            const std::uint32_t reach = portable::chord_reach(dx, radius * radius);
            for (std::uint32_t window = 0; reach != 0 && window < (plan_.period_y == 0 ? 1 : 3);
                 ++window)
                chords.push_back(
                    {portable::window_begin(window, near.sample.y, reach, plan_.height),
                     portable::window_end(window, near.sample.y, reach, plan_.height)});
        });
        std::sort(chords.begin(), chords.end(), [](Span a, Span b) { return a.begin < b.begin; });
        std::uint32_t free_from = place.begin;
        const auto append_to = [&](std::uint32_t free_to) {
            if (free_from < free_to) places_.push_back({place.x, place.width, free_from, free_to});
        };
        for (const Span chord : chords) {
            if (chord.begin >= chord.end) continue;
            append_to(std::min(chord.begin, place.end));
            free_from = std::max(free_from, chord.end);
        }
        append_to(place.end);
    }

    const Plan& plan_;
    const RadiusField& radius_field_;
    SizedSamples samples_;
    SizedSamples recent_;  // samples that have not cut the boxes yet
    std::vector<Rectangle> places_;
    std::vector<std::uint32_t> lengths_;
    std::vector<std::uint32_t> widths_;
};

}  // namespace

std::unique_ptr<FreeSpace> make_exact_with_field(const Plan& plan) {
    return std::make_unique<ExactWithField>(plan);
}

}  // namespace lacuna::reference
