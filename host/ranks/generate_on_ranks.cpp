// THE LOOP of generate.cpp on a strip. All ranks share only the marginal's total, the part of it
// below this strip, and the counts that decide how rounds continue.
#include "ranks/generate_on_ranks.h"

#include <algorithm>
#include <array>
#include <vector>

#include "plan/first_free.h"
#include "rounds/round_policy.h"
#include "sampling/timed_verbs.h"

namespace lacuna {
namespace {

// Numbers that are summed over the ranks after each round.
struct Sums {
    std::uint64_t total = 0;  // weight of all bins
    std::uint64_t bins = 0;
    std::uint64_t survivors = 0;
    std::uint64_t admitted = 0;
    std::uint64_t cancelled = 0;  // ranks whose observer cancelled

    void add_up(Ranks& ranks) {
        std::array<std::uint64_t, 5> all{total, bins, survivors, admitted, cancelled};
        ranks.sum(all);
        total = all[0];
        bins = all[1];
        survivors = all[2];
        admitted = all[3];
        cancelled = all[4];
    }
};

// The rank's own samples of a round, without guests, and the numbers of their draws.
class OwnSamples {
public:
    explicit OwnSamples(const Strip& strip) : strip_(strip) {}

    void find(const Round& round, std::uint32_t guests, const Marginal& marginal) {
        samples_.clear();
        numbers_.clear();
        for (std::size_t i = guests; i < round.samples.size(); ++i) {
            samples_.push_back(strip_.in_domain(round.samples[i]));
            numbers_.push_back(marginal.number_of(round.orders[i] - guests));
        }
    }
    std::span<const Sample> samples() const { return samples_; }
    std::span<const std::uint32_t> numbers() const { return numbers_; }

private:
    const Strip& strip_;
    std::vector<Sample> samples_;
    std::vector<std::uint32_t> numbers_;
};

// The rounds of one rank. A cancelled rank continues until all ranks know that it is cancelled.
class Rounds {
public:
    Rounds(const Plan& plan, const Strip& strip, Backend& backend, Ranks& ranks, Sink& sink,
           Observer& observer, std::uint32_t depth)
        : plan_(plan),
          ranks_(ranks),
          sink_(sink),
          observer_(observer),
          backend_(backend, observer),
          marginal_(strip.plan, backend.workers(), [this] { look_out(); }),
          policy_(plan),
          border_(strip, ranks, depth),
          own_(strip),
          all_free_(first_free_lengths(strip.plan)) {
        // While ranks wait for each other, no rank may keep a device that they share: each verb is
        // complete when it returns.
        backend.time_verbs();
        backend.watch([this] {
            look_out();
            return true;
        });
        rebuild(border_.own_lengths(all_free_), plan.strip_width);
        sums_.add_up(ranks_);
    }

    OutcomeOnRanks make() {
        while (sums_.total > 0 && outcome_.samples < plan_.limit) make_round();
        outcome_.maximal = outcome_.samples < plan_.limit;
        outcome_.samples = std::min(outcome_.samples, plan_.limit);
        outcome_.border = border_.tally();
        return outcome_;
    }

private:
    void make_round() {
        const CdfShare share{ranks_.sum_below(marginal_.total()), sums_.total};
        const auto size = static_cast<std::uint32_t>(policy_.size());
        backend_.locate(border_.draws_with_guests(backend_, marginal_, invert(size, share)));
        backend_.admit();
        if (policy_.refines())
            backend_.refine(policy_.halves());
        else
            backend_.subtract();
        const Round round = backend_.finish_round();
        border_.note(round, policy_.refines());

        own_.find(round, border_.guests(), marginal_);
        sink_.take(own_.samples(), own_.numbers(), size);
        rebuild(border_.own_lengths(round.free_lengths), round.bin_width);
        sums_.survivors = round.survivors - border_.guests();
        sums_.admitted = own_.samples().size();
        look_out();
        sums_.add_up(ranks_);
        if (sums_.cancelled > 0) throw Cancelled();

        outcome_.own_samples += own_.samples().size();
        outcome_.samples += sums_.admitted;
        outcome_.draws += size;
        outcome_.rounds++;
        policy_.note(sums_.survivors, sums_.admitted, sums_.bins, round.bin_width);
    }

    std::span<const Draw> invert(std::uint32_t size, CdfShare share) {
        const Timed timed(observer_, Verb::invert);
        return marginal_.invert(outcome_.draws, size, share);
    }
    void rebuild(std::span<const std::uint32_t> lengths, std::uint32_t width) {
        const Timed timed(observer_, Verb::invert);
        marginal_.rebuild(lengths, width);
        sums_.total = marginal_.total();
        sums_.bins = lengths.size();
    }
    void look_out() {
        const std::uint64_t expected = std::max(outcome_.samples, plan_.expected_samples);
        if (!observer_.keep_going({outcome_.samples, expected, outcome_.rounds}))
            sums_.cancelled = 1;
    }

    const Plan& plan_;
    Ranks& ranks_;
    Sink& sink_;
    Observer& observer_;
    TimedBackend<Backend> backend_;
    Marginal marginal_;
    RoundPolicy policy_;
    Border border_;
    OwnSamples own_;
    std::vector<std::uint32_t> all_free_;  // for the first round
    Sums sums_;
    OutcomeOnRanks outcome_;
};

}  // namespace

OutcomeOnRanks generate_on_ranks(const Plan& plan, const Strip& strip, Backend& backend,
                                 Ranks& ranks, Sink& sink, Observer& observer,
                                 std::uint32_t depth) {
    return Rounds(plan, strip, backend, ranks, sink, observer, depth).make();
}

}  // namespace lacuna
