// THE LOOP. The free space is a probability density: draw from it, admit draws that do not
// conflict, subtract the new disks, until the free space is empty (Kalantari & Sen 2011, sections 3
// and 4.1). In exact, free spans too thin for the strips are refined (docs/design.md, section 4).
#include "sampling/generate.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "backends/backends.h"
#include "backends/reference/reference.h"
#include "base/append.h"
#include "base/large_pages.h"
#include "plan/first_free.h"
#include "rounds/quota.h"
#include "rounds/round_policy.h"
#include "sampling/timed_verbs.h"
#include "space/portion.h"

namespace lacuna {

template <typename Placed>
OutcomeOf<Placed> generate(const Plan& plan, BackendOf<Placed>& untimed, Observer& observer,
                           const TakeSamplesOf<Placed>& take) {
    OutcomeOf<Placed> outcome;
    const auto may_go_on = [&] {
        const std::uint64_t points = outcome.count;
        const std::uint64_t expected = std::max(points, plan.expected_samples);
        return observer.keep_going({points, expected, outcome.rounds});
    };
    const auto poll = [&] {
        if (!may_go_on()) throw Cancelled();
    };
    TimedBackend backend(untimed, observer);
    TimedMarginal marginal(plan, untimed, poll, observer);
    RoundPolicy policy(plan);
    Quota quota(plan);
    untimed.watch(may_go_on);
    const FirstFree all_free(plan);
    marginal.rebuild(all_free.lengths, plan.strip_width, all_free.widths, all_free.copy_ends);

    while (marginal.total() > 0 && !quota.is_met()) {
        const std::span<const Draw> draws =
            marginal.invert(plan.first_draw + outcome.draws, policy.size());
        backend.locate(draws);
        backend.admit();
        if (policy.refines())
            backend.refine(policy.halves());
        else
            backend.subtract();
        const RoundOf<Placed> round = backend.finish_round();

        const std::span<const Placed> wanted = quota.wanted(round.samples);
        take(wanted);
        outcome.count += wanted.size();
        outcome.draws += draws.size();
        outcome.rounds++;
        policy.note(round.survivors, round.samples.size(), round.free_lengths.size(),
                    round.bin_width);
        marginal.rebuild(round.free_lengths, round.bin_width, round.bin_widths, round.copy_ends);
        poll();
    }
    outcome.is_cut = quota.is_met();
    outcome.work = untimed.work();
    return outcome;
}
template Outcome generate(const Plan&, BackendOf<Sample>&, Observer&, const TakeSamples&);
#ifndef LACUNA_CPU_ONLY
using space::SpaceSample;
template OutcomeOf<SpaceSample> generate(const Plan&, BackendOf<SpaceSample>&, Observer&,
                                         const TakeSamplesOf<SpaceSample>&);
#endif

Outcome generate(const Plan& plan, Backend& backend, Observer& observer) {
    std::vector<Sample> all;
    all.reserve(plan.expected_samples);
    ask_for_large_pages(all.data(), all.capacity());
    const TakeSamples keep = [&](std::span<const Sample> samples) {
        all.insert(all.end(), samples.begin(), samples.end());
    };
    Outcome outcome = generate<Sample>(plan, backend, observer, keep);
    outcome.samples = std::move(all);
    return outcome;
}

void begin_points(const CheckedRequest& request, std::size_t expected, Result& result) {
    const std::span<const Point> kept = request->keep.first(request.members());
    const std::span<const std::uint8_t> classes = request->keep_classes;
    const std::span<const std::uint8_t> of_kept =
        classes.first(std::min(classes.size(), kept.size()));
    result.points.reserve(kept.size() + expected);
    ask_for_large_pages(result.points.data(), result.points.capacity());
    result.points.assign(kept.begin(), kept.end());
    result.classes.assign(of_kept.begin(), of_kept.end());
}

void append_points(const Plan& plan, std::span<const Sample> samples, Workers& workers,
                   Result& result) {
    make_room_to_append(result.points, samples.size(), workers);
    for (const Sample& sample : samples) result.points.push_back(plan.to_user(sample));
    if (!plan.has_radius_field() || !plan.field().copies.are_several()) return;
    for (const Sample& sample : samples)
        result.classes.push_back(static_cast<std::uint8_t>(plan.class_of(sample)));
}

void cut_points(std::size_t count, Result& result) {
    result.points.resize(count);
    if (!result.classes.empty()) result.classes.resize(count);
}

namespace {

// `generate` runs the loop on the backend; the reference has a loop of its own.
template <typename Generate>
Run run_with(const Request& request, const Plan& plan, Observer& observer, Generate generate) {
    const ReadyBackend ready = make_backend(request.run_on, plan, observer);
#ifndef LACUNA_CPU_ONLY
    if (ready.backend == nullptr)
        return {reference::sample(plan, observer), ready.name, "1 thread"};
#endif
    return {generate(*ready.backend), ready.name, ready.backend->device()};
}

}  // namespace

Run run_on_backend(const Request& request, const Plan& plan, Observer& observer) {
    return run_with(request, plan, observer,
                    [&](Backend& backend) { return generate(plan, backend, observer); });
}

Run run_on_backend(const Request& request, const Plan& plan, Observer& observer,
                   const TakeSamples& take) {
    Run run = run_with(request, plan, observer, [&](Backend& backend) {
        return generate<Sample>(plan, backend, observer, take);
    });
    if (!run.outcome.samples.empty()) take(std::exchange(run.outcome.samples, {}));
    return run;
}

}  // namespace lacuna
