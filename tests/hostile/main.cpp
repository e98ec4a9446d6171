// hostile: random requests with every pair of capabilities (hostile/capabilities.h). All backends
// and numbers of threads must answer each alike, to the byte. Each set is proven by
// lacuna/verify.h and by a judge that shares no code with it (hostile/judge.h), which both must
// refute it without one point and with one that is too close.
//
//     hostile [--seconds S] [--seed N] [--skip K]
//
// The first requests cover all pairs; then come requests at random until S seconds (20) have
// passed. It prints the seed, which is a new one each time unless it is given; --skip goes to
// request K of the seed, and then not all pairs need be covered. Ends with 1 at the first fault,
// and names the request.
#include <lacuna/domains.h>
#include <lacuna/lacuna.h>
#include <lacuna/many.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
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

#include "hostile/capabilities.h"
#include "hostile/judge.h"
#include "hostile/options.h"
#include "hostile/random_request.h"

namespace {

using namespace lacuna;
using tests::Judge;
using tests::Made;

constexpr std::array<std::string_view, 3> kOptions{"--seconds", "--seed", "--skip"};
constexpr double kSeconds = 20;

struct Counts {
    std::uint64_t sets = 0, points = 0, comparisons = 0, proofs = 0;
    std::uint64_t refuted = 0;  // with one point less or too close
    std::uint64_t as_good = 0;  // without one point, because others cover its room
};

void demand(bool is_so, const std::string& otherwise) {
    if (!is_so) throw std::runtime_error(otherwise);
}

std::string told(Point at) {
    std::ostringstream out;
    out.precision(17);
    out << "(" << at.x << ", " << at.y << ")";
    return out.str();
}

// The available backends, the reference first.
std::vector<std::string> backends() {
    std::vector<std::string> names = {"reference", "cpu"};
    for (const Device& device : devices())
        if (device.unusable.empty() && (device.backend == "opencl" || device.backend == "vulkan") &&
            names.back() != device.backend)
            names.push_back(device.backend);
    return names;
}

// -------------------------------------------------------------------------------- all backends

// A set for each seed, or the reason why there is none, which must be the same on each backend.
struct Answer {
    std::vector<Result> sets;
    std::string refusal;
};

// The reference compares each point with the whole lattice of relax.
constexpr std::size_t kMostToRelax = 200;

void relax_some(const Made& made, const Request& request, std::vector<Point>& points) {
    points.resize(std::min(points.size(), kMostToRelax));
    RelaxOptions options;
    options.width = request.width;
    options.height = request.height;
    options.boundary = request.boundary;
    options.iterations = made.iterations;
    options.backend = request.backend;
    options.threads = request.threads;
    points = relax(points, &made.sparse, options).points;
}

// sample() makes the sets of the reference, and sample_many() the others where there are several.
Answer answer_of(const Made& made, const std::string& backend, std::uint32_t threads) {
    Request request = made.request;
    request.backend = backend;
    request.threads = threads;
    Answer answer;
    try {
        if (made.seeds.size() > 1 && backend != "reference") {
            sample_many(request, made.seeds,
                        [&](auto, Result set) { answer.sets.push_back(std::move(set)); });
        } else {
            for (const std::uint64_t seed : made.seeds) {
                request.seed = seed;
                answer.sets.push_back(sample(request));
            }
        }
        return answer;
    } catch (const BadRequest& error) {
        return {{}, error.what()};
    }
}

bool are_same(const Result& a, const Result& b) {
    const auto same_level = [](const Level& one, const Level& other) {
        return one.size == other.size && one.points == other.points;
    };
    return a.points == b.points && a.classes == b.classes && a.rounds == b.rounds &&
           a.draws == b.draws && a.maximal == b.maximal && a.radius == b.radius &&
           a.scale == b.scale && a.lines_per_radius == b.lines_per_radius &&
           std::equal(a.levels.begin(), a.levels.end(), b.levels.begin(), b.levels.end(),
                      same_level);
}

std::string told(const Answer& answer) {
    if (!answer.refusal.empty()) return answer.refusal;
    std::string text;
    for (const Result& set : answer.sets)
        text += std::to_string(set.points.size()) + " points, " + std::to_string(set.rounds) +
                " rounds, " + std::to_string(set.draws) + " draws; ";
    return text;
}

// The reference's answer, after all others have been found to be the same.
Answer answer_of_all(const Made& made, const std::vector<std::string>& names, Counts& counts) {
    const Answer expected = answer_of(made, names.front(), 1);
    const auto compare = [&](const std::string& name, std::uint32_t threads) {
        const Answer got = answer_of(made, name, threads);
        const bool is_same = expected.refusal == got.refusal &&
                             std::equal(expected.sets.begin(), expected.sets.end(),
                                        got.sets.begin(), got.sets.end(), are_same);
        demand(is_same, name + " with " + std::to_string(threads) + " threads answers: " +
                            told(got) + "\n  " + names.front() + " answers: " + told(expected));
        ++counts.comparisons;
    };
    for (std::size_t i = 1; i < names.size(); ++i) compare(names[i], made.request.threads);
    if (made.request.threads > 1) compare("cpu", 1);
    if (made.iterations == 0 || !expected.refusal.empty()) return expected;
    std::vector<Point> right;
    for (const std::string& name : names) {
        Request request = made.request;
        request.backend = name;
        std::vector<Point> points = expected.sets.front().points;
        relax_some(made, request, points);
        if (name == names.front()) right = points;
        demand(points == right, name + " relaxes to other points than " + names.front());
        ++counts.comparisons;
    }
    return expected;
}

// --------------------------------------------------------------------------------- proof of a set

struct Set {
    std::vector<Point> points;
    std::vector<std::uint8_t> classes;
    double size = 0;  // the radius or scale
    bool is_maximal = false;
};

Claim claim_of(const Made& made, const Set& set) {
    const Request& request = made.request;
    Claim claim;
    claim.width = request.width;
    claim.height = request.height;
    claim.boundary = request.boundary;
    claim.field = request.field;
    (request.field != nullptr ? claim.scale : claim.radius) = set.size;
    claim.mask = request.mask;
    claim.border = request.border;
    claim.keep = request.keep.first(std::min(request.keep.size(), set.points.size()));
    claim.classes = request.classes;
    claim.class_of_points = set.classes;
    claim.distances_only = !set.is_maximal;
    return claim;
}

void demand_proof(const Proof& proof, const Set& set, const std::string& by) {
    std::ostringstream out;
    out.precision(17);
    out << "a set is refuted by " << by << ": ";
    if (proof.outside)
        out << "point " << *proof.outside << " is outside";
    else if (proof.moved)
        out << "kept point " << *proof.moved << " has moved";
    else if (proof.forbidden)
        out << "point " << *proof.forbidden << " is forbidden";
    else if (!proof.kept)
        out << "points " << proof.first << " and " << proof.second << " are "
            << proof.least_distance << " apart, not " << proof.least_limit;
    else
        out << told(proof.largest_gap) << " is " << proof.largest_gap_distance
            << " from a point, not " << proof.largest_gap_limit;
    demand(proof.kept && (proof.covered || !set.is_maximal), out.str());
}

// Polygons are judged twice: prove() has their edges, and the judge compares the mask with them.
void judge_polygons(const Made& made, const Set& set, std::mt19937_64& random, Counts& counts) {
    Claim claim = claim_of(made, set);
    claim.mask = nullptr;
    claim.polygons = made.polygons;
    claim.edge_tolerance = made.edge;
    demand_proof(prove(set.points, claim), set, "its polygons");
    ++counts.proofs;
    const Judge judge(made, set.points, set.classes, set.size);
    const std::span<const Point> own =
        std::span(set.points).subspan(std::min(made.keep.size(), set.points.size()));
    for (const Point point : own)
        demand(judge.depth_of(point, false) >= -made.edge - judge.blur() &&
                   judge.depth_of(point, true) >= -made.edge - judge.blur(),
               told(point) + " lies outside of the polygons");
    for (int i = 0; i < 60; ++i) {
        const Point spot = verify::any_place(random, made.domain());
        if (judge.depth_of(spot, true) <= 2 * made.edge + judge.blur()) continue;
        demand(judge.is_in_mask(spot), told(spot) + " is not drawn onto the mask");
    }
}

// A set is refuted without one of its own points, unless others cover the room that it leaves.
void demand_refuted_without(const Made& made, Set set, std::size_t gone, std::mt19937_64& random,
                            Counts& counts) {
    const Point at = set.points[gone];
    const std::uint8_t kind = set.classes.empty() ? std::uint8_t{0} : set.classes[gone];
    const auto index = static_cast<std::ptrdiff_t>(gone);
    set.points.erase(set.points.begin() + index);
    if (!set.classes.empty()) set.classes.erase(set.classes.begin() + index);
    const std::string without = "without point " + std::to_string(gone) + " at " + told(at);
    const Proof proof = prove(set.points, claim_of(made, set));
    demand(proof.kept && !proof.forbidden, without + " what is left is refuted");
    const Judge judge(made, set.points, set.classes, set.size);
    if (proof.covered) {
        demand(judge.most_room_near(at, kind, random) <= judge.tolerance() * (1 + 1e-6),
               without + " there is room, and the proof does not find it");
        ++counts.as_good;
        return;
    }
    if (!set.points.empty() && judge.is_open(proof.largest_gap))
        demand(judge.room(proof.largest_gap, static_cast<std::uint8_t>(proof.largest_gap_class)) >
                   judge.tolerance() * (1 - 1e-6),
               without + " the gap at " + told(proof.largest_gap) + " is none");
    ++counts.refuted;
}

void demand_refuted_too_close(const Made& made, Set set, std::size_t moved, std::size_t other,
                              std::mt19937_64& random, Counts& counts) {
    const std::uint8_t kind = set.classes.empty() ? std::uint8_t{0} : set.classes[moved];
    const Judge before(made, set.points, set.classes, set.size);
    set.points[moved] = before.too_close_to(other, kind, random);
    const Judge judge(made, set.points, set.classes, set.size);
    if (!judge.is_open(set.points[moved]) || judge.fault().empty()) return;
    const Proof proof = prove(set.points, claim_of(made, set));
    demand(!proof.kept, "with " + told(set.points[moved]) + " too close to a point it is proven");
    ++counts.refuted;
}

void judge_exact(const Made& made, const Set& set, std::mt19937_64& random, Counts& counts) {
    const Judge judge(made, set.points, set.classes, set.size);
    demand(judge.fault().empty(), judge.fault());
    demand_proof(prove(set.points, claim_of(made, set)), set, "lacuna/verify.h");
    ++counts.proofs;
    if (!made.polygons.empty()) judge_polygons(made, set, random, counts);
    const std::size_t kept = made.keep.size();
    if (set.points.size() <= kept) return;
    const std::size_t one = kept + random() % (set.points.size() - kept);
    if (set.points.size() > 1)
        demand_refuted_too_close(made, set, one, (one + 1) % set.points.size(), random, counts);
    if (!set.is_maximal) return;
    const Judge::Gap gap = judge.largest_gap(random);
    demand(gap.room <= judge.tolerance() * (1 + 1e-6),
           told(gap.at) + " has room for class " + std::to_string(gap.kind) + ": " +
               std::to_string(gap.room / judge.tolerance()) + " times the tolerance");
    demand_refuted_without(made, set, one, random, counts);
}

// Modes lines and cells have no proof of coverage: their promises are those of lacuna/lacuna.h.
void judge_paper(const Made& made, const Set& set, std::mt19937_64& random) {
    const Judge judge(made, set.points, set.classes, set.size);
    demand(judge.fault().empty(), judge.fault());
    if (!set.is_maximal) return;
    if (made.request.mode == Mode::lines) {
        demand(judge.most_room_on_lines() <= judge.tolerance(), "a line has room");
    } else {
        const Judge::Gap gap = judge.largest_gap(random);
        demand(gap.room <= judge.tolerance(), told(gap.at) + " has room");
    }
}

void judge_set(const Made& made, const Result& result, std::mt19937_64& random, Counts& counts) {
    const Request& request = made.request;
    ++counts.sets;
    counts.points += result.points.size();
    if (request.mode == Mode::stratified) {
        demand(result.points.size() == *request.count, "the count is another");
        return;
    }
    const std::uint64_t most = std::min(request.limit.value_or(result.points.size()),
                                        request.count.value_or(result.points.size()));
    demand(result.points.size() <= std::max<std::uint64_t>(most, made.keep.size()),
           "there are more points than were asked for");
    demand(result.maximal || result.points.size() >= most, "the set ended early");
    const double size = request.field != nullptr ? result.scale : result.radius;
    const Set whole{result.points, result.classes, size, result.maximal};
    if (request.mode != Mode::exact) return judge_paper(made, whole, random);
    judge_exact(made, whole, random, counts);
    if (result.levels.empty()) return;
    const Level& level = result.levels[random() % result.levels.size()];
    Set prefix{result.points, result.classes, level.size, true};
    prefix.points.resize(std::min<std::size_t>(level.points, result.points.size()));
    if (prefix.points.size() < level.points) return;  // cut by a limit
    if (!prefix.classes.empty()) prefix.classes.resize(prefix.points.size());
    judge_exact(made, prefix, random, counts);
}

// ------------------------------------------------------------------------------------- the program

class Program {
public:
    explicit Program(const tests::HostileOptions& options)
        : options_(options), names_(backends()), rows_(options.seed) {}

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
            const Answer answer = answer_of_all(*made, names_, counts_);
            demand(answer.refusal.empty(), "a request is refused: " + answer.refusal);
            std::mt19937_64 random(number);
            for (const Result& set : answer.sets) judge_set(*made, set, random, counts_);
            covered_.cover(tests::levels_of(*made));
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
            const auto made = tests::RandomRequest(options_.seed, refusals_, row).make(true);
            const std::string told_of = tests::describe(row);
            const Answer answer = answer_of_all(*made, names_, counts_);
            const auto begins = [&](std::string_view option) {
                return answer.refusal.starts_with(std::string(option) + " ");
            };
            demand(std::any_of(refused->options.begin(), refused->options.end(), begins),
                   "it is not refused with the option's name, but answered: " + told(answer) +
                       "\n  " + told_of);
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
    Counts counts_;
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
