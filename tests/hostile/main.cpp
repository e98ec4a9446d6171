// hostile: random requests with every pair of capabilities, of sample() (hostile/capabilities.h),
// of stipple() (hostile/stippling.h) and of sets in space (hostile/in_space.h). All backends,
// numbers of threads and lacuna.h must answer each alike, to the byte. Each set is proven by
// lacuna/verify.h and by tests/judge, which shares no code with it, and both must find the same in
// it with a point less, moved or too close. Each request is made once more on a domain that lies
// elsewhere, and its set is proven there.
//
//     hostile [sample | stipple | space] [--requests N] [--only CAPABILITY] [--on BACKEND] [--seed
//     S]
//             [--skip K]
//
// The first requests cover all pairs; then come N (0) at random. It prints the seed, which is a new
// one each time unless it is given, and at the end a hash of all points: two versions of the
// library that make the same sets print the same. With --only all requests have the capability, and
// with --on one backend answers. --skip goes to request K of the seed; then N (1) requests are
// made, and not all pairs need be covered. Ends with 1 at the first fault, and names the request.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "hostile/answers.h"
#include "hostile/capabilities.h"
#include "hostile/door_to_c.h"
#include "hostile/in_space.h"
#include "hostile/judge_counts.h"
#include "hostile/judge_elsewhere.h"
#include "hostile/judge_set.h"
#include "hostile/judge_stippling.h"
#include "hostile/judge_tiles.h"
#include "hostile/options.h"
#include "hostile/random_request.h"

namespace {

using namespace lacuna;
using tests::demand;

// Makes requests by a table of capabilities, and counts the pairs that were judged.
class Program {
public:
    Program(const tests::HostileOptions& options, std::vector<std::string> names,
            const tests::Tables& tables)
        : options_(options),
          names_(std::move(names)),
          tables_(tables),
          rows_(options.seed),
          planned_(tables, options.only),
          covered_(tables, options.only) {}
    virtual ~Program() = default;

    void run() {
        std::uint64_t number = 0;
        const bool covers = options_.skip == 0;
        std::uint64_t more =
            covers ? options_.requests : std::max<std::uint64_t>(1, options_.requests);
        for (; (covers && planned_.covered() < planned_.allowed()) || number < options_.skip ||
               more != 0;
             ++number) {
            const bool is_more =
                number >= options_.skip && (!covers || planned_.covered() == planned_.allowed());
            const tests::Row row = planned_.next(rows_);
            planned_.cover(row);
            if (is_more) --more;
            if (number >= options_.skip) checked(row, number);
        }
        if (covers) check_refusals();
        tell();
        demand(!covers || covered_.covered() == covered_.allowed(), "not all pairs were covered");
    }

protected:
    // Judges a request of this row, and adds what it is to a message about it.
    virtual void check(const tests::Row& row, std::uint64_t number, std::string& what) = 0;
    // What a request is answered that breaks a line of the table.
    virtual std::string answer(const tests::Row& row, const tests::Refused& refused) = 0;

    void add_to_hash(std::span<const Point> points) {
        for (const Point& point : points)
            for (const double value : {point.x, point.y})
                hash_ = (hash_ ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3U;
    }

    const tests::HostileOptions options_;
    const std::vector<std::string> names_;
    tests::Counts counts_;

private:
    void checked(const tests::Row& row, std::uint64_t number) {
        std::string what = describe(tables_, row);
        try {
            check(row, number, what);
            covered_.cover(row);
            ++counts_.requests;
        } catch (const std::exception& error) {
            throw std::runtime_error(std::string(error.what()) + "\n  at --seed " +
                                     std::to_string(options_.seed) + " --skip " +
                                     std::to_string(number) + ": " + what);
        }
    }

    // What is refused is refused by all backends in the same words, which name an option.
    void check_refusals() {
        for (const auto& [row, refused] : planned_.refused_rows(rows_)) {
            const std::string told = answer(row, *refused);
            demand(std::any_of(refused->options.begin(), refused->options.end(),
                               [&](std::string_view option) {
                                   return told.starts_with(std::string(option) + " ");
                               }),
                   "it is not refused with the option's name, but answered: " + told + "\n  " +
                       describe(tables_, row));
            ++counts_.refusals;
        }
    }

    void tell() const {
        std::cout << "hostile: " << counts_.requests << " requests, " << counts_.sets << " sets of "
                  << counts_.points << " points judged, " << counts_.comparisons << " comparisons, "
                  << counts_.proofs << " proofs; changed sets: " << counts_.refuted << " refuted, "
                  << counts_.as_good << " as good, " << counts_.filled << " filled by gaps\n  "
                  << covered_.covered() << " of " << covered_.allowed() << " pairs covered, "
                  << counts_.refusals << " refused; failures 0; hash of all points " << std::hex
                  << hash_ << std::dec << std::endl;
    }

    const tests::Tables& tables_;
    std::uint64_t hash_ = 0xcbf29ce484222325U;  // FNV-1a, of the doubles' bits
    std::mt19937_64 rows_;
    tests::Pairs planned_;
    tests::Pairs covered_;  // by requests that were made and judged
};

class Sets : public Program {
public:
    Sets(const tests::HostileOptions& options, const std::vector<std::string>& names)
        : Program(options, names, tests::kSampling) {}

private:
    void check(const tests::Row& row, std::uint64_t number, std::string& what) override {
        const auto made = tests::RandomRequest(options_.seed, number, row).make(false);
        what = tests::describe(*made);
        demand(tests::levels_of(*made) == row, "the request does not have its levels");
        const tests::Answer answer = tests::answer_of_all(*made, names_, counts_);
        // A count in a place that is a hair wide needs points nearer than the grid can have them.
        // The refusal must name the count, as no radius was given.
        if (answer.refusal.starts_with("count ") &&
            answer.refusal.find("grid's units run out") != std::string::npos)
            return;
        demand(answer.refusal.empty(), "a request is refused: " + answer.refusal);
        if (made->frame > 0) {
            made->keep = answer.frame.points;
            made->keep_classes = answer.frame.classes;
            made->keep_all();
        } else {
            tests::judge_in_c(*made, answer, counts_);
        }
        std::mt19937_64 random(number);
        for (const Result& set : answer.sets) tests::judge_set(*made, set, random, counts_);
        for (const Result& set : answer.sets) add_to_hash(set.points);
        tests::judge_limit(made->request, answer.sets.front());
        if (made->frame > 0)
            tests::judge_tiles(*made, answer.sets.front(), answer.sets.back(), random, counts_);
        tests::judge_elsewhere(*made, names_, random, counts_);
        if (made->is_moved())
            tests::judge_moved(*made, answer.sets.front().points.size(), answer.moved);
        tests::judge_counts(*made, answer.sets, names_, random, counts_);
        tests::judge_priority(*made, names_, random, counts_);
    }

    // What relax() refuses needs a set, so that sample() must not refuse the request.
    std::string answer(const tests::Row& row, const tests::Refused& refused) override {
        const bool is_of_sample = refused.first != tests::kRelax;
        const auto made =
            tests::RandomRequest(options_.seed, counts_.refusals, row).make(is_of_sample);
        return tests::told(tests::answer_of_all(*made, names_, counts_));
    }
};

class Drawings : public Program {
public:
    Drawings(const tests::HostileOptions& options, const std::vector<std::string>& names)
        : Program(options, names, tests::kStippling) {}

private:
    void check(const tests::Row& row, std::uint64_t number, std::string& what) override {
        const tests::Drawing drawing = tests::RandomDrawing(options_.seed, number, row).make();
        what += ";" + drawing.words;
        const tests::Dots dots = tests::dots_of_all(drawing, names_, counts_);
        demand(dots.refusal.empty(), "dots are refused: " + dots.refusal);
        tests::judge_in_c(drawing, dots.made, counts_);
        tests::judge_dots(drawing, dots.made, counts_);
        add_to_hash(dots.made.result.points);
    }

    std::string answer(const tests::Row& row, const tests::Refused&) override {
        const tests::Drawing drawing =
            tests::RandomDrawing(options_.seed, counts_.refusals, row).make();
        const tests::Dots dots = tests::dots_of_all(drawing, names_, counts_);
        return dots.refusal.empty() ? "dots" : dots.refusal;
    }
};

class SetsInSpace : public Program {
public:
    SetsInSpace(const tests::HostileOptions& options, const std::vector<std::string>& names)
        : Program(options, names, tests::kSpace) {}

private:
    void check(const tests::Row& row, std::uint64_t number, std::string&) override {
        tests::MadeInSpace made;
        tests::RandomInSpace(options_.seed, number, row).make(made);
        const tests::AnswerInSpace answer = tests::answer_of_all(made.request, names_, counts_);
        demand(answer.refusal.empty(), "a request is refused: " + answer.refusal);
        std::mt19937_64 random(number);
        tests::judge_in_space(made, answer.set, random, counts_);
        for (const Point3& at : answer.set.points)
            add_to_hash(std::vector<Point>{{at.x, at.y}, {at.z, 0}});
    }

    std::string answer(const tests::Row& row, const tests::Refused&) override {
        tests::MadeInSpace made;
        tests::RandomInSpace(options_.seed, counts_.refusals, row).make(made);
        const tests::AnswerInSpace answer = tests::answer_of_all(made.request, names_, counts_);
        return answer.refusal.empty() ? "a set" : answer.refusal;
    }
};

// The reference first.
std::vector<std::string> backends_of(const tests::HostileOptions& options) {
    if (!options.on.empty()) return {options.on, options.on};
    return tests::backends();
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const tests::HostileOptions options = tests::read_hostile_options(argc, argv);
        const std::vector<std::string> names = backends_of(options);
        std::cout << "hostile: seed " << options.seed << ", backends";
        for (const std::string& name : names) std::cout << " " << name;
        std::cout << std::endl;
        if (options.samples) Sets(options, names).run();
        if (options.stipples) Drawings(options, names).run();
        if (options.in_space) SetsInSpace(options, names).run();
    } catch (const std::exception& error) {
        std::cerr << "hostile: " << error.what() << std::endl;
        return EXIT_FAILURE;
    }
}
