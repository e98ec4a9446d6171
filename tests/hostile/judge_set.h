// Judges sets by lacuna/verify.h and by hostile/judge.h, which both must refute a set without one
// point and with one that is too close.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "hostile/answers.h"
#include "hostile/counts.h"
#include "hostile/judge.h"
#include "hostile/made.h"

namespace lacuna::tests {

struct Set {
    std::vector<Point> points;
    std::vector<std::uint8_t> classes;
    double size = 0;  // the radius or scale
    bool is_maximal = false;
};

inline Claim claim_of(const Made& made, const Set& set) {
    const Request& request = made.request;
    Claim claim;
    claim.domain = request.domain;
    claim.field = request.field;
    (request.field != nullptr ? claim.scale : claim.radius) = set.size;
    claim.mask = request.mask;
    claim.border = request.border;
    // A limit cuts kept points; then neighbours do not matter.
    const bool is_cut = set.points.size() < made.keep.size();
    claim.keep = is_cut ? request.keep.first(set.points.size()) : request.keep;
    if (!is_cut) claim.keep_classes = request.keep_classes;
    claim.classes = request.classes;
    claim.class_of_points = set.classes;
    // Sets are judged without some of their points, too.
    for (std::size_t i = 0; i < claim.classes.counts.size(); ++i)
        if (std::optional<std::uint64_t>& own = claim.classes.counts[i])
            own = std::count(set.classes.begin(), set.classes.end(), static_cast<std::uint8_t>(i));
    claim.distances_only = !set.is_maximal;
    return claim;
}

inline void demand_proof(const Proof& proof, const Set& set, const std::string& by) {
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
inline void judge_polygons(const Made& made, const Set& set, std::mt19937_64& random,
                           Counts& counts) {
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
        demand(judge.depth_of(point, true) >= 0, told(point) + " lies outside of the polygons");
    for (int i = 0; i < 60; ++i) {
        const Point spot = verify::any_place(random, made.domain());
        if (judge.depth_of(spot, true) <= 2 * made.edge + judge.blur()) continue;
        demand(judge.is_in_mask(spot), told(spot) + " is not drawn onto the mask");
    }
}

// A set is refuted without one of its own points, unless others cover the room that it leaves.
inline void demand_refuted_without(const Made& made, Set set, std::size_t gone,
                                   std::mt19937_64& random, Counts& counts) {
    const Point at = set.points[gone];
    const std::uint8_t kind = set.classes.empty() ? std::uint8_t{0} : set.classes[gone];
    const auto& numbers = made.request.classes.counts;
    if (!numbers.empty() && numbers[kind]) return;  // there may have been room before
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
    const auto of_gap = static_cast<std::uint8_t>(proof.largest_gap_class);
    if (!set.points.empty() && judge.is_open(proof.largest_gap, of_gap))
        demand(judge.room(proof.largest_gap, of_gap) > judge.tolerance() * (1 - 1e-6),
               without + " the gap at " + told(proof.largest_gap) + " is none");
    ++counts.refuted;
}

inline void demand_refuted_too_close(const Made& made, Set set, std::size_t moved,
                                     std::size_t other, std::mt19937_64& random, Counts& counts) {
    const std::uint8_t kind = set.classes.empty() ? std::uint8_t{0} : set.classes[moved];
    const Judge before(made, set.points, set.classes, set.size);
    set.points[moved] = before.too_close_to(other, kind, random);
    const Judge judge(made, set.points, set.classes, set.size);
    if (!judge.is_open(set.points[moved], kind) || judge.fault().empty()) return;
    const Proof proof = prove(set.points, claim_of(made, set));
    demand(!proof.kept, "with " + told(set.points[moved]) + " too close to a point it is proven");
    ++counts.refuted;
}

inline void judge_exact(const Made& made, const Set& set, std::mt19937_64& random, Counts& counts) {
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
inline void judge_paper(const Made& made, const Set& set, std::mt19937_64& random) {
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

// All moved points stay, in the domain, and on a picture where it has importance.
inline void judge_moved(const Made& made, std::span<const Point> given,
                        std::span<const Point> moved) {
    demand(moved.size() == std::min(given.size(), kMostToMove), "points were lost in moving");
    const Judge judge(made, given, {}, 1);
    for (const Point point : moved) {
        demand(made.domain().contains(point), told(point) + " was moved out of the domain");
        demand(judge.has_importance(point, made.sparse),
               told(point) + " was moved to where the picture is white");
    }
}

inline void judge_set(const Made& made, const Result& result, std::mt19937_64& random,
                      Counts& counts) {
    const Request& request = made.request;
    ++counts.sets;
    counts.points += result.points.size();
    if (request.mode == Mode::stratified || request.mode == Mode::pixels) {
        demand(result.points.size() == *request.count, "the count is another");
        std::set<std::pair<double, double>> places;
        for (const Point& point : result.points) places.insert({point.x, point.y});
        demand(request.mode == Mode::stratified || places.size() == result.points.size(),
               "a pixel has two points");
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

}  // namespace lacuna::tests
