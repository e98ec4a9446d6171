// The search for the radius or scale of a count. Sizes come from the density of maximal sets
// (docs/design.md, section 5) and from the number of points that the trial before gave.
#include "sampling/count_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plan/checked_request.h"
#include "plan/make_plan.h"
#include "plan/sizes.h"

namespace lacuna {
namespace {

// Trials aim at this many standard deviations more than the count. A maximal set of one radius then
// falls short for 3 seeds in 100,000.
constexpr double kDeviations = 4;
// With a field, trials aim at this factor more, because the formula is less exact there.
constexpr double kFieldSpare = 1.015;

double with_deviations(double count) {
    return count + kDeviations * kCountDeviation * std::sqrt(count);
}

// The request at a size, its radius or scale, instead of a count, for at most `most` points. A
// limit of the request does not cut trials: the size must not depend on it.
CheckedRequest at_size(const CheckedRequest& request, double size, std::uint64_t most) {
    return request.with([&](Request& trial) {
        (trial.field != nullptr ? trial.scale : trial.radius) = size;
        trial.count.reset();
        trial.limit = most;
    });
}

// One radius. The first trial has enough points for all but a few seeds. Each further trial aims
// at 5 % more.
class RadiusSearch : public CountSearch {
public:
    explicit RadiusSearch(const CheckedRequest& request) : request_(request) {}

    Trial next() override {
        constexpr double kMoreEachTrial = 1.05;
        // A set of mode lines has 0.2 / m fewer points than a maximal one, m lines per radius.
        const double loss =
            request_->mode == Mode::exact ? 1 : 1 + 0.2 / lines_per_radius(request_);
        const double wanted = with_deviations(static_cast<double>(*request_->count)) * loss *
                              std::pow(kMoreEachTrial, trials_++);
        const double radius = radius_expecting(request_, wanted);
        check_radius_for_count(request_, radius);
        return {.request = at_size(request_, radius, *request_->count)};
    }
    bool is_enough(std::uint64_t points) override { return points == *request_->count; }

private:
    CheckedRequest request_;
    int trials_ = 0;
};

// Mode cells: pilots correct the formula first, because in rough fields the metric min admits more
// samples than it expects. The first pilot has a coarse lattice, further ones have the request's.
// Then trials follow as for one radius.
class LatticeSearch : public CountSearch {
public:
    LatticeSearch(const CheckedRequest& request, const FieldSums& sums)
        : request_(request), sums_(sums), scale_(scale_for_count(request, sums, *request->count)) {}

    Trial next() override {
        if (is_piloting_) return {.request = pilot_ = next_pilot(), .is_pilot = true};
        // The spare room grows with the number n of trials before: kFieldSpare^(1 + n (n + 1) / 2).
        const double scale = scale_by_pilot(pilot_points_, 1 + trials_ * (trials_ + 1) / 2);
        ++trials_;
        return {.request = at_size(request_, scale, *request_->count)};
    }

    bool is_enough(std::uint64_t points) override {
        if (!is_piloting_) return points == *request_->count;
        pilot_points_ = points;
        is_piloting_ = corrections_++ < kFarCorrections && correct_scale();
        return false;
    }

private:
    // A pilot whose points are this factor off the count says little about the right scale: at one
    // scale a single sample may cover the field, and at a slightly smaller one there may be
    // thousands. A pilot ends early at the square of this factor, 16 times the count.
    static constexpr std::uint64_t kFar = 4;
    static constexpr std::uint32_t kCoarse = 4;  // lines per radius; a sixth of the work of 10
    static constexpr int kCorrections = 3;       // most further pilots if the last one was near
    static constexpr int kFarCorrections = 20;   // most if the last one was far off
    static constexpr double kClose = 0.08;       // smaller corrections of the scale end the pilots

    CheckedRequest next_pilot() const {
        const std::uint32_t own = lines_per_radius(request_);
        return at_size(request_, scale_, kFar * kFar * *request_->count).with([&](Request& pilot) {
            pilot.paper2011.lines_per_radius = corrections_ == 0 ? std::min(own, kCoarse) : own;
            pilot.paper2011.round_size = 0;
            pilot.run_on.backend = "cpu";
            pilot.run_on.device.clear();
        });
    }

    // The scale that follows from the last pilot, with kFieldSpare^spares times the count. The
    // pilot's lattice may be coarser, which is corrected as in a smooth field. A pilot without
    // points has a lattice that missed all pixels with importance, and counts as half a point.
    double scale_by_pilot(std::uint64_t points, int spares) const {
        const double finer =
            samples_at_radius_one(request_, sums_) / samples_at_radius_one(pilot_, sums_);
        const double maximal = std::max(static_cast<double>(points), 0.5) * finer;
        const double wanted =
            with_deviations(static_cast<double>(*request_->count)) * std::pow(kFieldSpare, spares);
        const double scale = *pilot_->scale * std::sqrt(maximal / wanted);
        check_scale_for_count(request_, sums_, scale);
        return scale;
    }

    // Returns whether another pilot is needed, and then corrects scale_ for it. scale_ stays
    // between the scales that were found too small and too large.
    bool correct_scale() {
        const std::uint64_t count = *request_->count;
        const bool is_far = pilot_points_ < count / kFar || pilot_points_ > kFar * count;
        if (corrections_ > kCorrections && !is_far) return false;
        double next = scale_by_pilot(std::max(pilot_points_, count / (kFar * kFar)), 1);
        if (next > (1 - kClose) * scale_ && next < (1 + kClose) * scale_) return false;
        if (is_far) {
            (pilot_points_ < count ? too_large_ : too_small_) = scale_;
            if (too_large_ < (1 + kClose) * too_small_) return false;
            if (next <= too_small_ || next >= too_large_) next = std::sqrt(too_small_ * too_large_);
        }
        scale_ = next;
        return true;
    }

    CheckedRequest request_;
    const FieldSums& sums_;
    double scale_;  // of the next pilot
    double too_small_ = 0;
    double too_large_ = std::numeric_limits<double>::infinity();
    bool is_piloting_ = true;
    int corrections_ = 0;
    CheckedRequest pilot_ = request_;
    std::uint64_t pilot_points_ = 0;
    int trials_ = 0;  // without pilots
};

// With a radius field each trial is a maximal set, whose points correct the size of the next one. A
// set with far too many points is no answer: its first points alone are far from maximal.
class FieldSearch : public CountSearch {
public:
    FieldSearch(const CheckedRequest& request, const Poll& poll)
        : request_(request),
          poll_(poll),
          wanted_(kFieldSpare * with_deviations(static_cast<double>(*request->count))),
          size_(radius_field_scale_for_count(request, wanted_, poll)) {}

    Trial next() override {
        // The trial's plan would name the scale, which is not the caller's.
        if (size_ < checked_) check_radius_field_size(*request_, size_, poll_);
        checked_ = std::min(checked_, size_);
        return {.request = at_size(request_, size_, static_cast<std::uint64_t>(4 * wanted_) + 16)};
    }

    bool is_enough(std::uint64_t points) override {
        constexpr double kMost = 1.05;  // accept up to this many times what was wanted,
        constexpr int kPatience = 12;   // and after this many trials any larger set
        const auto made = static_cast<double>(points);
        const bool is_patient = trials_++ < kPatience;
        const bool has_all = points >= *request_->count;
        if (has_all && (made <= kMost * wanted_ || !is_patient)) return true;
        // Points grow with the square of the size. A trial changes them by a factor of 4 at most.
        size_ *= std::sqrt(std::clamp(made / wanted_, 0.25, 4.0));
        if (!has_all && !is_patient) size_ *= 0.9;
        return false;
    }

private:
    CheckedRequest request_;
    Poll poll_;
    double wanted_;  // points
    double size_;    // the scale, or without a field the radius
    double checked_ = std::numeric_limits<double>::infinity();  // the least size that was checked
    int trials_ = 0;
};

}  // namespace

std::unique_ptr<CountSearch> search_for_count(const CheckedRequest& request, const FieldSums* sums,
                                              const Poll& poll) {
    if (sums != nullptr) return std::make_unique<LatticeSearch>(request, *sums);
    if (needs_radius_field(request)) return std::make_unique<FieldSearch>(request, poll);
    return std::make_unique<RadiusSearch>(request);
}

}  // namespace lacuna
