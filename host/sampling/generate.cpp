// THE LOOP. The free space is a probability density: draw from it, admit draws that do not
// conflict, subtract the new disks, until the free space is empty (Kalantari & Sen 2011, sections 3
// and 4.1). In exact, free spans too thin for the strips are refined (docs/design.md, section 4).
#include "sampling/generate.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "backends/backends.h"
#include "backends/reference/reference.h"
#include "base/large_pages.h"
#include "plan/first_free.h"
#include "rounds/round_policy.h"
#include "sampling/timed_verbs.h"

namespace lacuna {

Outcome generate(const Plan& plan, Backend& untimed, Observer& observer) {
    Outcome outcome;
    outcome.samples.reserve(plan.expected_samples);
    ask_for_large_pages(outcome.samples.data(), plan.expected_samples);
    const auto may_go_on = [&] {
        const std::uint64_t points = outcome.samples.size();
        const std::uint64_t expected = std::max(points, plan.expected_samples);
        return observer.keep_going({points, expected, outcome.rounds});
    };
    const auto poll = [&] {
        if (!may_go_on()) throw Cancelled();
    };
    TimedBackend backend(untimed, observer);
    TimedMarginal marginal(plan, backend.workers(), poll, observer);
    RoundPolicy policy(plan);
    backend.watch(may_go_on);
    const FirstFree all_free(plan);
    marginal.rebuild(all_free.lengths, plan.strip_width, all_free.widths, all_free.sheet_ends);

    while (marginal.total() > 0 && outcome.samples.size() < plan.limit) {
        const std::span<const Draw> draws =
            marginal.invert(plan.first_draw + outcome.draws, policy.size());
        backend.locate(draws);
        backend.admit();
        if (policy.refines())
            backend.refine(policy.halves());
        else
            backend.subtract();
        const Round round = backend.finish_round();

        outcome.samples.insert(outcome.samples.end(), round.samples.begin(), round.samples.end());
        outcome.draws += draws.size();
        outcome.rounds++;
        policy.note(round.survivors, round.samples.size(), round.free_lengths.size(),
                    round.bin_width);
        marginal.rebuild(round.free_lengths, round.bin_width, round.bin_widths, round.sheet_ends);
        poll();
    }
    outcome.work = untimed.work();
    if (outcome.samples.size() > plan.limit) outcome.samples.resize(plan.limit);
    return outcome;
}

void begin_points(const Request& request, Result& result) {
    result.points.assign(request.keep.begin(), request.keep.end());
    result.classes.assign(request.keep_classes.begin(), request.keep_classes.end());
}

void append_points(const Plan& plan, std::span<const Sample> samples, Result& result) {
    result.points.reserve(result.points.size() + samples.size());
    ask_for_large_pages(result.points.data(), result.points.capacity());
    for (const Sample& sample : samples) result.points.push_back(plan.to_user(sample));
    if (!plan.has_field() || !plan.field().sheets.are_several()) return;
    for (const Sample& sample : samples)
        result.classes.push_back(static_cast<std::uint8_t>(plan.class_of(sample)));
}

void cut_points(std::size_t count, Result& result) {
    result.points.resize(count);
    if (!result.classes.empty()) result.classes.resize(count);
}

Run run_on_backend(const Request& request, const Plan& plan, Observer& observer) {
    const ReadyBackend ready = make_backend(request.place, plan, observer);
#ifndef LACUNA_CPU_ONLY
    if (ready.backend == nullptr)
        return {reference::sample(plan, observer), ready.name, "1 thread"};
#endif
    return {generate(plan, *ready.backend, observer), ready.name, ready.backend->device()};
}

}  // namespace lacuna
