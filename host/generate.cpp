// THE LOOP. The free space is a probability density: draw from it, keep what does not conflict,
// take the new disks out of it, until nothing is left (Kalantari & Sen 2011, sections 3 and 4.1).
// In exact, what is left too thin for its strips to show is refined (DESIGN section 4).
#include "generate.h"

#include <algorithm>

#include "rounds/marginal.h"
#include "rounds/round_policy.h"

namespace lacuna {
namespace {

// Tells the observer where the time goes, also when a verb throws.
class Timed {
public:
    Timed(Observer& observer, Verb verb) : observer_(observer), verb_(verb) {
        observer_.begin(verb_);
    }
    ~Timed() { observer_.end(verb_); }
    Timed(const Timed&) = delete;
    Timed& operator=(const Timed&) = delete;

private:
    Observer& observer_;
    Verb verb_;
};

template <typename Work>
auto timed(Observer& observer, Verb verb, Work work) {
    const Timed timing(observer, verb);
    return work();
}

}  // namespace

Outcome generate(const Plan& plan, Backend& backend, Observer& observer) {
    Outcome outcome;
    outcome.samples.reserve(plan.expected_samples);
    const auto may_go_on = [&] {
        const std::uint64_t points = outcome.samples.size();
        const std::uint64_t expected = std::max(points, plan.expected_samples);
        return observer.keep_going({points, expected, outcome.rounds});
    };
    const auto poll = [&] {
        if (!may_go_on()) throw Cancelled();
    };
    backend.watch(may_go_on);
    const std::vector<std::uint32_t> all_free = first_free_lengths(plan);
    Marginal marginal(plan, poll);
    marginal.rebuild(all_free, plan.strip_width);
    RoundPolicy policy(plan);

    while (marginal.total() > 0 && outcome.samples.size() < plan.limit) {
        const std::span<const Draw> draws = timed(observer, Verb::invert, [&] {
            return marginal.invert(outcome.draws, static_cast<std::uint32_t>(policy.size()));
        });
        timed(observer, Verb::locate, [&] { backend.locate(draws); });
        timed(observer, Verb::admit, [&] { backend.admit(); });
        if (policy.refines())
            timed(observer, Verb::refine, [&] { backend.refine(policy.halves()); });
        else
            timed(observer, Verb::subtract, [&] { backend.subtract(); });
        const Round round = timed(observer, Verb::transfer, [&] { return backend.finish_round(); });

        outcome.samples.insert(outcome.samples.end(), round.samples.begin(), round.samples.end());
        outcome.draws += draws.size();
        outcome.rounds++;
        policy.note(round.survivors, round.samples.size(), round.free_lengths.size(),
                    round.place_width);
        timed(observer, Verb::invert,
              [&] { marginal.rebuild(round.free_lengths, round.place_width); });
        poll();
    }
    if (outcome.samples.size() > plan.limit) outcome.samples.resize(plan.limit);
    return outcome;
}

}  // namespace lacuna
