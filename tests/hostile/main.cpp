// hostile: random requests with every pair of capabilities (hostile/capabilities.h). All backends
// and numbers of threads must answer each alike, to the byte. Each set is proven by
// lacuna/verify.h and by a judge that shares no code with it (hostile/judge.h), which both must
// refute it without one point and with one that is too close. Each request is made once more on a
// domain that lies elsewhere, and its set is proven there.
//
//     hostile [--seconds S] [--seed N] [--skip K]
//
// The first requests cover all pairs; then come requests at random until S seconds (20) have
// passed. It prints the seed, which is a new one each time unless it is given; --skip goes to
// request K of the seed, and then not all pairs need be covered. Ends with 1 at the first fault,
// and names the request.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "hostile/answers.h"
#include "hostile/capabilities.h"
#include "hostile/judge_counts.h"
#include "hostile/judge_elsewhere.h"
#include "hostile/judge_set.h"
#include "hostile/options.h"
#include "hostile/random_request.h"

namespace {

using namespace lacuna;
using tests::Answer;
using tests::demand;
using tests::Made;

constexpr std::array<std::string_view, 3> kOptions{"--seconds", "--seed", "--skip"};
constexpr double kSeconds = 20;

class Program {
public:
    explicit Program(const tests::HostileOptions& options)
        : options_(options), names_(tests::backends()), rows_(options.seed) {}

    void run() {
        std::cout << "hostile: seed " << options_.seed << ", backends";
        for (const std::string& name : names_) std::cout << " " << name;
        std::cout << std::endl;
        using Clock = std::chrono::steady_clock;
        const Clock::time_point start = Clock::now();
        const double seconds = options_.seconds.value_or(kSeconds);
        const auto has_time = [&] {
            return std::chrono::duration<double>(Clock::now() - start).count() < seconds;
        };
        std::uint64_t number = 0;
        for (bool goes_on = true; goes_on; ++number) {
            const tests::Row row = planned_.next(rows_);
            planned_.cover(row);
            if (number >= options_.skip) check(row, number);
            const bool is_covering = options_.skip == 0 && planned_.covered() < planned_.allowed();
            goes_on = number < options_.skip || is_covering || has_time();
        }
        if (options_.skip == 0) check_refusals();
        tell(number - options_.skip);
        demand(options_.skip != 0 || covered_.covered() == covered_.allowed(),
               "not all pairs were covered");
    }

private:
    void check(const tests::Row& row, std::uint64_t number) {
        std::unique_ptr<Made> made;
        try {
            made = tests::RandomRequest(options_.seed, number, row).make(false);
            demand(tests::levels_of(*made) == row, "the request does not have its levels");
            const Answer answer = tests::answer_of_all(*made, names_, counts_);
            demand(answer.refusal.empty(), "a request is refused: " + answer.refusal);
            std::mt19937_64 random(number);
            for (const Result& set : answer.sets) tests::judge_set(*made, set, random, counts_);
            tests::judge_elsewhere(*made, names_, random, counts_);
            if (made->is_moved())
                tests::judge_moved(*made, answer.sets.front().points, answer.moved);
            covered_.cover(tests::levels_of(*made));
            tests::judge_counts(*made, answer.sets, names_, random, counts_);
        } catch (const std::exception& error) {
            throw std::runtime_error(std::string(error.what()) + "\n  at --seed " +
                                     std::to_string(options_.seed) + " --skip " +
                                     std::to_string(number) + ": " +
                                     (made ? tests::describe(*made) : tests::describe(row)));
        }
    }

    // What is refused is refused by all backends in the same words, which name an option.
    void check_refusals() {
        for (const auto& [row, refused] : planned_.refused_rows(rows_)) {
            // What relax() refuses needs a set, so that sample() must not refuse the request.
            const bool is_of_sample = refused->first != tests::kRelax;
            const auto made =
                tests::RandomRequest(options_.seed, refusals_, row).make(is_of_sample);
            const std::string told_of = tests::describe(row);
            const Answer answer = tests::answer_of_all(*made, names_, counts_);
            const auto begins = [&](std::string_view option) {
                return answer.refusal.starts_with(std::string(option) + " ");
            };
            demand(std::any_of(refused->options.begin(), refused->options.end(), begins),
                   "it is not refused with the option's name, but answered: " +
                       tests::told(answer) + "\n  " + told_of);
            ++refusals_;
        }
    }

    void tell(std::uint64_t requests) const {
        std::cout << "hostile: " << requests << " requests, " << counts_.sets << " sets of "
                  << counts_.points << " points judged, " << counts_.comparisons << " comparisons, "
                  << counts_.proofs << " proofs; with one point less or too close "
                  << counts_.refuted << " refuted, " << counts_.as_good << " as good\n  "
                  << covered_.covered() << " of " << covered_.allowed() << " pairs covered, "
                  << refusals_ << " refused; failures 0" << std::endl;
    }

    const tests::HostileOptions options_;
    const std::vector<std::string> names_;
    std::mt19937_64 rows_;
    tests::Pairs planned_;
    tests::Pairs covered_;  // by requests that were made and judged
    tests::Counts counts_;
    std::uint64_t refusals_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    try {
        Program(tests::read_hostile_options(argc, argv, kOptions)).run();
    } catch (const std::exception& error) {
        std::cerr << "hostile: " << error.what() << std::endl;
        return EXIT_FAILURE;
    }
}
