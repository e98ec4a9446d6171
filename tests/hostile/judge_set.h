// Judges sets by lacuna/verify.h and by tests/judge, which must find the same: in the set, without
// one point, with one that is too close or moved, and in one that the proof's gaps have filled.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
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
#include "hostile/made.h"
#include "judge/cells.h"
#include "judge/judge.h"
#include "judge/places_of.h"

namespace lacuna::tests {

using judge::Judge;
using judge::Random;

// A set, and what it is judged by.
struct Set {
    const Request& request;
    std::vector<Point> points{};
    std::vector<std::uint8_t> classes{};
    double size = 0;  // the radius or scale
    bool is_maximal = false;
    std::size_t kept = 0;                    // own points, which the request keeps
    std::span<const PolygonSet> polygons{};  // in place of a mask
    double edge = 0;

    Judge judge() const { return Judge(request, points, classes, size, polygons, edge); }
    std::uint8_t kind_of(std::size_t point) const { return classes.empty() ? 0 : classes[point]; }
    bool has_number(std::uint8_t kind) const {
        return !request.classes.counts.empty() && request.classes.counts[kind];
    }
    void erase(std::size_t point) {
        points.erase(points.begin() + static_cast<std::ptrdiff_t>(point));
        if (!classes.empty()) classes.erase(classes.begin() + static_cast<std::ptrdiff_t>(point));
    }
    // A point that may be taken away, if there is one.
    std::optional<std::size_t> any_own(Random& random) const {
        if (points.size() <= kept) return std::nullopt;
        const std::size_t own = kept + random() % (points.size() - kept);
        // There may have been room for a class that has a number.
        return has_number(kind_of(own)) ? std::nullopt : std::optional(own);
    }
};

inline Claim claim_of(const Set& set) {
    const Request& request = set.request;
    Claim claim;
    claim.domain = request.domain;
    claim.field = request.field;
    (request.field != nullptr ? claim.scale : claim.radius) = set.size;
    claim.places = request.places;
    if (!set.polygons.empty()) claim.places.mask = nullptr;
    claim.places.outlines = places_of(set.polygons, set.edge).outlines;
    claim.places.edge = set.edge;
    // A limit cuts kept points; then neighbours do not matter.
    const bool is_cut = set.points.size() < set.kept;
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

inline std::string told(const Proof& proof) {
    std::ostringstream out;
    out.precision(17);
    if (proof.outside)
        out << "point " << *proof.outside << " is outside";
    else if (proof.moved)
        out << "kept point " << *proof.moved << " has moved";
    else if (proof.forbidden)
        out << "point " << *proof.forbidden << " is forbidden";
    else
        out << "points " << proof.first << " and " << proof.second << " are "
            << proof.least_distance << " apart of " << proof.least_limit << "; "
            << told(proof.largest_gap) << " is " << proof.largest_gap_distance
            << " from a point, of " << proof.largest_gap_limit << ", for class "
            << proof.largest_gap_class;
    return out.str();
}

inline Proof demand_proof(const Set& set, const Claim& claim, const std::string& by,
                          Counts& counts) {
    const Proof proof = prove(set.points, claim);
    demand(proof.kept && (proof.covered || !set.is_maximal),
           "a set is refuted by " + by + ": " + told(proof));
    ++counts.proofs;
    return proof;
}

// The proof names the pair that is the closest for the judge, too.
inline void demand_same_pair(const Set& set, const Judge& judge, const Proof& proof) {
    if (set.points.size() < set.kept) return;
    const Judge::Closest pair = judge.closest();
    const bool is_plain = std::abs(pair.share - 1) > 1e-11;
    demand(!is_plain || proof.kept == (pair.share >= 1),
           "the closest pair, " + std::to_string(pair.first) + " and " +
               std::to_string(pair.second) + ", has " + std::to_string(pair.share) +
               " of its limit, but: " + told(proof));
    if (std::isinf(pair.share)) return;
    const auto site_of = [&](std::size_t point) {
        return point < set.points.size() ? point : point - set.kept;
    };
    const double share = judge.share_of(site_of(proof.first), site_of(proof.second));
    // Below a millionth of its limit the proof names any pair.
    demand(share <= std::max(pair.share * (1 + 1e-9), 1e-6),
           "another pair is closer than " + told(proof));
    const bool is_uniform =
        set.request.field == nullptr && set.classes.empty() && proof.second < set.points.size();
    const double distance =
        is_uniform && proof.first != proof.second
            ? judge::distance(set.request.domain, set.points[proof.first], set.points[proof.second])
            : proof.least_distance;
    demand(proof.least_distance == distance, "the distance is another one: " + told(proof));
}

// What the proof says of a changed set is so, and near the change the judge finds no larger gap.
inline void demand_findings(const Set& set, const std::string& change, Point place,
                            std::uint8_t kind, Random& random, Counts& counts) {
    const Proof proof = prove(set.points, claim_of(set));
    const std::string with = change + ": ";
    const Judge judge = set.judge();
    demand(!proof.outside && !proof.moved && proof.forbidden == judge.astray(),
           with + told(proof) + "; the judge says: " + judge.fault());
    if (proof.forbidden) return void(++counts.refuted);
    demand_same_pair(set, judge, proof);
    if (!proof.kept) ++counts.refuted;
    if (!set.is_maximal) return;
    const Judge::Gap near = judge.largest_gap_near(place, kind, random);
    if (proof.covered) {
        demand(near.room <= judge.tolerance() * (1 + 1e-6),
               with + told(near.at) + " has room, and the proof does not find it");
        ++counts.as_good;
        return;
    }
    ++counts.refuted;
    const auto of_gap = static_cast<std::uint8_t>(proof.largest_gap_class);
    if (set.points.empty() || !judge.is_open(proof.largest_gap, of_gap)) return;
    const double room = judge.room(proof.largest_gap, of_gap);
    demand(room > judge.tolerance() * (1 - 1e-6), with + "no gap: " + told(proof));
    const double rounding = 2e-6 * proof.largest_gap_distance + 4 * judge.blur();
    demand(near.room <= room + rounding,
           with + told(near.at) + " has more room than the largest gap: " + told(proof));
}

inline void judge_changes(const Set& set, Random& random, Counts& counts) {
    const std::optional<std::size_t> one = set.any_own(random);
    if (!one) return;
    const Point was = set.points[*one];
    const std::uint8_t kind = set.kind_of(*one);
    const std::string point = "point " + std::to_string(*one) + " at " + told(was);
    if (set.is_maximal) {
        Set less = set;
        less.erase(*one);
        demand_findings(less, "without " + point, was, kind, random, counts);
    }
    if (!set.classes.empty()) {
        Set other = set;
        other.classes[*one] =
            static_cast<std::uint8_t>((kind + 1U) % set.request.classes.names.size());
        demand_findings(other, "with another class of " + point, was, kind, random, counts);
    }
    const Judge judge = set.judge();
    const std::optional<judge::Shape> shape = judge.shape_at(was);
    if (set.points.size() < 2 || !shape) return;
    const double angle = judge::any_in(random, 0, 7), way = shape->shorter / 50;
    const Point beside = judge::wrapped(
        set.request.domain, {was.x + way * std::cos(angle), was.y + way * std::sin(angle)});
    const Point too_close = judge.too_close_to((*one + 1) % set.points.size(), kind, random);
    for (const Point to : {beside, too_close}) {
        if (!judge.is_open(to, kind)) continue;
        Set moved = set;
        moved.points[*one] = to;
        demand_findings(moved, "with " + point + " at " + told(to), was, kind, random, counts);
    }
}

// Without some of its points the set is filled by the proof's own gaps, and maximal again.
inline void judge_filled(const Set& set, Random& random, Counts& counts) {
    Set filled = set;
    for (int i = 0; i < 6; ++i)
        if (const auto one = filled.any_own(random)) filled.erase(*one);
    const Domain& domain = set.request.domain;
    const double right = domain.x0 + domain.width, top = domain.y0 + domain.height;
    for (std::size_t most = set.points.size() + 60;;) {
        const Proof proof = prove(filled.points, claim_of(filled));
        demand(proof.kept, "a set that is filled by its gaps: " + told(proof));
        if (proof.covered) break;
        demand(filled.points.size() < most, "no end of gaps");
        Point gap = proof.largest_gap;  // may lie on the upper edges, where no new point may
        if (gap.x >= right) gap.x = domain.wraps() ? domain.x0 : std::nextafter(right, domain.x0);
        if (gap.y >= top) gap.y = domain.wraps() ? domain.y0 : std::nextafter(top, domain.y0);
        filled.points.push_back(gap);
        if (!set.request.classes.names.empty())
            filled.classes.push_back(static_cast<std::uint8_t>(proof.largest_gap_class));
    }
    const Judge judge = filled.judge();
    demand(judge.fault().empty(), "filled by gaps: " + judge.fault());
    const Judge::Gap gap = judge.largest_gap(random);
    demand(gap.room <= judge.tolerance() * (1 + 1e-6), "filled by gaps: room at " + told(gap.at));
    ++counts.filled;
}

inline void judge_exact(const Set& set, Random& random, Counts& counts) {
    const Judge judge = set.judge();
    demand(judge.fault().empty(), judge.fault());
    demand_same_pair(set, judge, demand_proof(set, claim_of(set), "lacuna/verify.h", counts));
    if (set.is_maximal) {
        const Judge::Gap gap = judge.largest_gap(random);
        demand(gap.room <= judge.tolerance() * (1 + 1e-6),
               told(gap.at) + " has room for class " + std::to_string(gap.kind) + ": " +
                   std::to_string(gap.room / judge.tolerance()) + " times the tolerance");
        if (random() % 3 == 0) judge_filled(set, random, counts);
    }
    judge_changes(set, random, counts);
}

// Polygons are judged twice: prove() has their edges, and the judge compares the mask with them.
inline void judge_polygons(const Made& made, Set set, Random& random, Counts& counts) {
    const Judge by_mask = set.judge();
    for (std::size_t i = set.kept; i < set.points.size(); ++i)
        demand(judge::depth_in(made.polygons, set.points[i]) >= 0,
               told(set.points[i]) + " lies outside of the polygons");
    for (int i = 0; i < 60; ++i) {
        const Point spot = judge::any_place(random, made.request.domain);
        if (judge::depth_in(made.polygons, spot) <= 2 * made.edge + by_mask.blur()) continue;
        demand(by_mask.is_in_mask(spot), told(spot) + " is not drawn onto the mask");
    }
    set.polygons = made.polygons;
    set.edge = made.edge;
    demand_proof(set, claim_of(set), "its polygons", counts);
}

// Modes lines and cells have no proof of coverage: their promises are those of lacuna/lacuna.h.
inline void judge_paper(const Set& set) {
    if (set.request.mode == Mode::lines) {
        const Judge judge = set.judge();
        demand(judge.fault().empty(), judge.fault());
        demand(!set.is_maximal || judge.most_room_on_lines() <= judge.tolerance(),
               "a line has room");
        return;
    }
    Request request = set.request;
    request.scale = set.size;
    request.paper2011.lines_per_radius = request.paper2011.lines_per_radius.value_or(10);
    const judge::CellsJudge judge(request, set.points);
    demand(judge.fault().empty(), judge.fault());
    const std::string room = set.is_maximal ? judge.room() : "";
    demand(room.empty(), room);
}

// All moved points stay, in the domain, and on a picture where it has importance.
inline void judge_moved(const Made& made, std::size_t given, std::span<const Point> moved) {
    demand(moved.size() == std::min(given, kMostToMove), "points were lost in moving");
    Request picture{.domain = made.request.domain};
    if (!made.sparse.importance.empty()) picture.field = &made.sparse;
    const std::string fault = Judge(picture, moved, {}, 0).fault();
    demand(fault.empty(), "moved: " + fault);
}

// The levels of a progressive order become smaller, down to what was asked for, and each is proven.
inline void judge_levels(const Request& request, const Result& result, Set set, Counts& counts) {
    const std::vector<Level>& levels = result.levels;
    demand(levels.empty() != request.progressive || !result.maximal,
           "an order without levels, or levels of another set");
    if (result.maximal && !levels.empty())
        demand(levels.back().points == result.points.size() && levels.back().size == set.size,
               "the last level is another");
    for (std::size_t i = levels.size(); i-- != 0;) {
        demand(i == 0 || levels[i - 1].size > levels[i].size, "a level is no smaller");
        if (set.points.size() < levels[i].points) continue;  // cut by a limit
        set.points.resize(levels[i].points);
        set.classes.resize(set.classes.empty() ? 0 : levels[i].points);
        set.size = levels[i].size;
        set.is_maximal = true;
        demand_proof(set, claim_of(set), "level " + std::to_string(i), counts);
    }
}

// A limit gives the first points of the set that has none.
inline void judge_limit(const Request& request, const Result& result) {
    if (!request.limit) return;
    Request whole = request;
    whole.limit.reset();
    const Result all = sample(whole);
    demand(std::equal(result.points.begin(), result.points.end(), all.points.begin()) &&
               std::equal(result.classes.begin(), result.classes.end(), all.classes.begin()),
           "a limit gives other points than the first ones");
}

inline void judge_set(const Made& made, const Result& result, Random& random, Counts& counts) {
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
    Set set{request,        result.points,
            result.classes, request.field != nullptr ? result.scale : result.radius,
            result.maximal, made.keep.size()};
    if (request.mode != Mode::exact) return judge_paper(set);
    judge_exact(set, random, counts);
    if (!made.polygons.empty()) judge_polygons(made, set, random, counts);
    judge_levels(request, result, set, counts);
    if (result.levels.empty()) return;
    const Level& level = result.levels[random() % result.levels.size()];
    if (set.points.size() < level.points) return;  // cut by a limit
    set.points.resize(level.points);
    if (!set.classes.empty()) set.classes.resize(level.points);
    set.size = level.size;
    set.is_maximal = true;
    judge_exact(set, random, counts);
}

}  // namespace lacuna::tests
