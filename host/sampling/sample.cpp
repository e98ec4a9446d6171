// lacuna::sample: makes a plan of the request, runs a backend's rounds, and returns the points.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "base/asked.h"
#include "base/large_pages.h"
#include "base/polling.h"
#include "checks/classes.h"
#include "dither/on_pixels.h"
#include "lacuna/lacuna.h"
#include "lattice/stratified.h"
#include "plan/checked_request.h"
#include "plan/kept.h"
#include "plan/make_plan.h"
#include "plan/plan.h"
#include "plan/sizes.h"
#include "sampling/class_stages.h"
#include "sampling/count_search.h"
#include "sampling/generate.h"
#include "sampling/progressive.h"

namespace lacuna {
namespace {

// The progress before there is a point.
Progress nothing_yet(const Request& request) {
    return {0, request.count.value_or(request.limit.value_or(1)), 0};
}

// `sums` are the field's sums, in mode cells only.
Result run(const CheckedRequest& request, const std::optional<FieldSums>& sums,
           Observer& observer) {
    const Plan plan = sums                          ? make_cells_plan(request, *sums, ask)
                      : needs_radius_field(request) ? make_radius_field_plan(request, ask)
                                                    : make_plan(request);
    Result result;
    begin_points(request, plan.expected_samples, result);
    Workers workers(request->run_on.threads);
    const Run run = run_on_backend(request, plan, observer, [&](std::span<const Sample> samples) {
        append_points(plan, samples, workers, result);
    });
    result.radius = plan.user_radius;
    result.scale = plan.user_scale;
    result.lines_per_radius = plan.lines_per_radius;
    result.maximal = !run.outcome.is_cut;
    result.rounds = run.outcome.rounds;
    result.draws = run.outcome.draws;
    result.work = run.outcome.work;
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

// Sets without distances, which the host makes by itself.
Result counted(const Request& request, Observer& observer, const Poll& poll) {
    Result result;
    observer.begin(Verb::invert);
    result.points =
        request.on_pixels ? points_on_pixels(request, poll) : stratified_points(request, poll);
    observer.end(Verb::invert);
    if (request.on_pixels) result.radius = least_pixel_step(*request.on_pixels, request.domain);
    result.draws = result.points.size();
    result.backend = "cpu";
    return result;
}

}  // namespace

Work& Work::operator+=(const Work& other) {
    launches += other.launches;
    waits += other.waits;
    uploads += other.uploads;
    downloads += other.downloads;
    uploaded_bytes += other.uploaded_bytes;
    downloaded_bytes += other.downloaded_bytes;
    for (const KernelWork& more : other.kernels) {
        const auto known =
            std::find_if(kernels.begin(), kernels.end(),
                         [&](const KernelWork& kernel) { return kernel.name == more.name; });
        if (known == kernels.end()) {
            kernels.push_back(more);
            continue;
        }
        known->launches += more.launches;
        known->items += more.items;
        known->seconds += more.seconds;
    }
    return *this;
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
        case Verb::descend:
            return "descend";
        case Verb::read:
            return "read";
        case Verb::pen_path:
            return "pen_path";
    }
    return "";
}

namespace {

Result sample_checked(const CheckedRequest& request, Observer& observer) {
    if (request->mode == Mode::stratified || request->mode == Mode::pixels)
        return counted(request, observer, ask);
    if (request->progressive) return progressive(request, observer, ask);
    std::optional<FieldSums> sums;
    if (request->mode == Mode::cells) sums = sums_of(*request->field, ask);
    if (!request->count) {
        check_kept_distances(request, request.places_of_kept());
        if (has_stages(request->classes)) return sample_in_stages(request, observer, ask);
        return run(request, sums, observer);
    }

    // A count: the first points of a maximal set that has somewhat more.
    const auto search = search_for_count(request, sums ? &*sums : nullptr, ask);
    Silent silent(observer);
    for (;;) {
        const Trial trial = search->next();
        Observer& watching = trial.is_pilot ? silent : observer;
        Result result = run(trial.request, sums, watching);
        if (!search->is_enough(result.points.size())) continue;
        check_kept_distances(
            trial.request,
            trial.request.places_of_kept());  // at this size kept points may be too close together
        const std::uint64_t most =
            std::min(*request->count, request->limit.value_or(*request->count));
        result.maximal = result.maximal && result.points.size() <= most;
        cut_points(most, result);
        return result;
    }
}

}  // namespace

Result sample(const Request& request, Observer& observer) {
    Asked asked(observer, nothing_yet(request));
    const CheckedRequest checked(request);
    Result result = sample_checked(checked, asked);
    result.edge = checked.edge();
    if (request.classes.names.size() == 1) result.classes.assign(result.points.size(), 0);
    return result;
}

Result sample(const Request& request) {
    Observer nobody;
    return sample(request, nobody);
}

}  // namespace lacuna
