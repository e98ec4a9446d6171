// THE LOOP. The free space is a probability density: draw from it, keep what does not conflict,
// take the new disks out of it, until nothing is left (Kalantari & Sen 2011, sections 3 and 4.1).
#include "generate.h"

#include <algorithm>

#include "marginal.h"
#include "rounds.h"

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

void report(const Plan& plan, const Outcome& outcome, Observer& observer) {
    const std::uint64_t points = outcome.samples.size();
    if (!observer.keep_going({points, std::max(points, plan.expected_samples), outcome.rounds}))
        throw Cancelled();
}

}  // namespace

Outcome generate(const Plan& plan, Backend& backend, Observer& observer) {
    Outcome outcome;
    Marginal marginal(plan);
    marginal.rebuild(std::vector<std::uint32_t>(plan.lines, plan.height));
    std::uint64_t round_size = first_round_size(plan);

    while (marginal.total() > 0 && outcome.samples.size() < plan.limit) {
        const std::span<const Draw> draws = timed(observer, Verb::invert, [&] {
            return marginal.invert(outcome.draws, static_cast<std::uint32_t>(round_size));
        });
        timed(observer, Verb::locate, [&] { backend.locate(draws); });
        timed(observer, Verb::admit, [&] { backend.admit(); });
        timed(observer, Verb::subtract, [&] { backend.subtract(); });
        const Round round = timed(observer, Verb::transfer, [&] { return backend.finish_round(); });

        outcome.samples.insert(outcome.samples.end(), round.samples.begin(), round.samples.end());
        outcome.draws += draws.size();
        outcome.rounds++;
        round_size = next_round_size(plan, round_size, round.samples.size());
        timed(observer, Verb::invert, [&] { marginal.rebuild(round.free_lengths); });
        report(plan, outcome, observer);
    }
    if (outcome.samples.size() > plan.limit) outcome.samples.resize(plan.limit);
    return outcome;
}

}  // namespace lacuna
