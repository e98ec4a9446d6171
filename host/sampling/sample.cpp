// lacuna::sample: makes a plan of the request, runs a backend's rounds, and returns the points.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "backends/backends.h"
#include "base/large_pages.h"
#include "lacuna/lacuna.h"
#include "plan/kept.h"
#include "plan/plan.h"

namespace lacuna {
namespace {

// Asks whether to go on before there is a point.
void ask(const Request& request, Observer& observer) {
    const std::uint64_t expected = request.count.value_or(request.limit.value_or(1));
    if (!observer.keep_going({0, expected, 0})) throw Cancelled();
}

// The request must have been checked. `sums` are the field's sums, in mode cells only.
Result run(const Request& request, const std::optional<FieldSums>& sums, Observer& observer) {
    const Poll poll = [&] { ask(request, observer); };
    const Plan plan = sums                          ? make_cells_plan(request, *sums, poll)
                      : needs_radius_field(request) ? make_radius_field_plan(request, poll)
                                                    : make_plan(request);
    const Run run = run_on_backend(request, plan, observer);
    Result result;
    result.points.reserve(request.keep.size() + run.outcome.samples.size());
    ask_for_large_pages(result.points.data(), run.outcome.samples.size());
    result.points.assign(request.keep.begin(), request.keep.end());
    for (const Sample& sample : run.outcome.samples) result.points.push_back(plan.to_user(sample));
    result.radius = plan.user_radius;
    result.scale = plan.user_scale;
    result.lines_per_radius = plan.lines_per_radius;
    result.maximal = run.outcome.samples.size() < plan.limit;
    result.rounds = run.outcome.rounds;
    result.draws = run.outcome.draws;
    result.backend = run.backend;
    result.device = run.device;
    return result;
}

// Passes on whether to go on, but no points and no rounds.
class Silent : public Observer {
public:
    explicit Silent(Observer& observer) : observer_(observer) {}
    bool keep_going(const Progress& progress) override {
        return observer_.keep_going({0, progress.expected_points, 0});
    }

private:
    Observer& observer_;
};

// A trial set that shows how many points a scale gives: maximal, or ended early when it has far
// more points than the count.
struct Pilot {
    Request request;
    std::uint64_t points;
};

// A pilot whose points are this factor off the count says little about the right scale: at one
// scale a single sample may cover the field, and at a slightly smaller one there may be thousands.
constexpr std::uint64_t kFar = 4;

bool is_far(const Pilot& pilot, std::uint64_t count) {
    return pilot.points < count / kFar || pilot.points > kFar * count;
}

Pilot run_pilot(const Request& request, const FieldSums& sums, double scale,
                std::uint32_t cells_per_radius, Observer& observer) {
    Pilot pilot{request, 0};
    pilot.request.scale = scale;
    pilot.request.count.reset();
    pilot.request.limit = kFar * kFar * *request.count;
    pilot.request.round_size = 0;
    pilot.request.lines_per_radius = cells_per_radius;
    pilot.request.backend = "cpu";
    pilot.request.device.clear();
    Silent silent(observer);
    pilot.points = run(pilot.request, sums, silent).points.size();
    return pilot;
}

// The first pilot has the scale from the formula of docs/design.md, section 5, on a coarse lattice.
// Rough fields miss the count. Then further pilots, on the request's own lattice, take the scale
// that follows from the pilot before; it stays between scales that were too small and too large.
Pilot find_pilot(const Request& request, const FieldSums& sums, Observer& observer) {
    constexpr std::uint32_t kCoarse = 4;  // cells per radius; a sixth of the work of 10
    constexpr int kCorrections = 3;       // most further pilots when the count is near
    constexpr int kFarCorrections = 20;   // and when it is far off
    const std::uint64_t count = *request.count;
    const std::uint32_t own = request.lines_per_radius.value_or(kCellsPerRadius);
    double scale = scale_for_count(request, sums, count);
    double too_large = std::numeric_limits<double>::infinity();
    double too_small = 0;
    Pilot pilot = run_pilot(request, sums, scale, std::min(own, kCoarse), observer);
    for (int i = 0; i < kFarCorrections; ++i) {
        const bool far = is_far(pilot, count);
        if (i >= kCorrections && !far) break;
        const std::uint64_t points = std::max(pilot.points, count / (kFar * kFar));
        double next = scale_for_count(request, sums, count, pilot.request, points, 0);
        if (next > 0.92 * scale && next < 1.08 * scale) break;
        if (far) {
            (pilot.points < count ? too_large : too_small) = scale;
            if (too_large < 1.08 * too_small) break;
            if (next <= too_small || next >= too_large) next = std::sqrt(too_small * too_large);
        }
        scale = next;
        pilot = run_pilot(request, sums, scale, own, observer);
    }
    return pilot;
}

// A count with a radius field: the first `count` points of a maximal set that has a few more. The
// scale or radius comes from the formula first, then from the number of points of the set before:
// on rough fields the metric min admits more samples than the formula expects.
Result fill_radius_field(const Request& request, Observer& observer) {
    constexpr double kSpare = 1.015;  // aim at this many times the count
    constexpr double kMost = 1.05;    // accept up to this many times the aim,
    constexpr int kPatience = 12;     // and after this many attempts any larger set
    const auto count = static_cast<double>(*request.count);
    const double wanted = kSpare * (count + 4 * kCountDeviation * std::sqrt(count));
    Request sized = request;
    sized.count.reset();
    sized.limit.reset();
    const auto poll = [&] { ask(request, observer); };
    double scale = radius_field_scale_for_count(request, wanted, poll);
    for (int attempt = 0;; ++attempt) {
        (request.field != nullptr ? sized.scale : sized.radius) = scale;
        sized.limit = static_cast<std::uint64_t>(4 * wanted) + 16;
        Result result = run(sized, {}, observer);
        const auto made = static_cast<double>(result.points.size());
        const bool is_enough = made >= count;
        if (is_enough && (made <= kMost * wanted || attempt >= kPatience)) {
            check_kept_distances(sized);  // at this size kept points may be too close together
            result.maximal = made == count && result.maximal;
            result.points.resize(std::min(*request.count, request.limit.value_or(*request.count)));
            return result;
        }
        scale *= std::sqrt(std::clamp(made / wanted, 0.25, 4.0));
        if (!is_enough && attempt >= kPatience) scale *= 0.9;
    }
}

}  // namespace

std::string_view name_of(Mode mode) {
    switch (mode) {
        case Mode::exact:
            return "exact";
        case Mode::lines:
            return "lines";
        case Mode::cells:
            return "cells";
    }
    return "";
}

std::string_view name_of(Metric metric) {
    switch (metric) {
        case Metric::min:
            return "min";
        case Metric::mean:
            return "mean";
        case Metric::max:
            return "max";
    }
    return "";
}

std::string_view name_of(Verb verb) {
    switch (verb) {
        case Verb::invert:
            return "invert";
        case Verb::locate:
            return "locate";
        case Verb::admit:
            return "admit";
        case Verb::subtract:
            return "subtract";
        case Verb::refine:
            return "refine";
        case Verb::transfer:
            return "transfer";
        case Verb::first_use:
            return "first_use";
        case Verb::assign:
            return "assign";
        case Verb::accumulate:
            return "accumulate";
        case Verb::move:
            return "move";
    }
    return "";
}

Result sample(const Request& request, Observer& observer) {
    check_request(request);
    std::optional<FieldSums> sums;
    if (request.mode == Mode::cells)
        sums = sums_of(*request.field, [&] { ask(request, observer); });
    if (!request.count) {
        check_kept_distances(request);
        return run(request, sums, observer);
    }

    if (needs_radius_field(request)) return fill_radius_field(request, observer);

    // A count: the radius has some room to spare, so that the first attempt has enough points, for
    // all but a few in a hundred thousand seeds. Otherwise the next attempt has more to spare.
    const std::uint64_t count = *request.count;
    std::optional<Pilot> pilot;
    if (sums) pilot = find_pilot(request, *sums, observer);
    for (int attempt = 0;; ++attempt) {
        Request sized = request;
        if (pilot)
            sized.scale =
                scale_for_count(request, *sums, count, pilot->request, pilot->points, attempt);
        else
            sized.radius = radius_for_count(request, attempt);
        sized.count.reset();
        sized.limit = std::min(count, request.limit.value_or(count));
        Result result = run(sized, sums, observer);
        if (result.points.size() == *sized.limit) return result;
    }
}

Result sample(const Request& request) {
    Observer nobody;
    return sample(request, nobody);
}

}  // namespace lacuna
