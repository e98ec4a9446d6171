// Judges the sets of a request of classes once more, with a number of points for one of them, and
// with one class after the other.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "hostile/answers.h"
#include "hostile/counts.h"
#include "hostile/door_to_c.h"
#include "hostile/judge_set.h"
#include "hostile/made.h"

namespace lacuna::tests {

inline bool may_have_stages(const Made& made) {
    const Request& request = made.request;
    return request.classes.names.size() > 1 && made.frame == 0 && !request.count &&
           !request.limit && !request.progressive;
}

inline std::uint64_t points_of_class(std::size_t of_class, std::span<const std::uint8_t> classes) {
    return static_cast<std::uint64_t>(
        std::count(classes.begin(), classes.end(), static_cast<std::uint8_t>(of_class)));
}

// The sets that the request had without a number are `sets`. One point more than the kept ones has
// room in them, and more may have.
inline void judge_counts(Made& made, const std::vector<Result>& sets,
                         const std::vector<std::string>& names, Random& random, Counts& counts) {
    Request& request = made.request;
    Classes& classes = request.classes;
    const std::size_t kinds = classes.names.size();
    if (!may_have_stages(made)) return;
    const std::size_t kind = random() % kinds;
    const std::uint64_t kept = points_of_class(kind, made.keep_classes);
    std::uint64_t most = points_of_class(kind, sets.front().classes);
    for (const Result& set : sets) most = std::min(most, points_of_class(kind, set.classes));
    if (most <= kept) return;
    const std::uint64_t wanted = kept + 1 + random() % (most - kept);
    classes.counts.assign(kinds, {});
    classes.counts[kind] = wanted;

    const Answer answer = answer_of_all(made, names, counts);
    const std::string asked =
        "with " + std::to_string(wanted) + " points of " + classes.names[kind] + " ";
    const bool may_lack_room =
        wanted > kept + 1 && answer.refusal.find("found room") != std::string::npos;
    demand(answer.refusal.empty() || may_lack_room,
           asked + "a request is refused: " + answer.refusal);
    for (const Result& set : answer.sets) {
        demand(points_of_class(kind, set.classes) == wanted, asked + "there are others");
        judge_set(made, set, random, counts);
    }
}

// A set without the points of classes behind `last`, but for those that were kept.
inline Result without_later(Result set, std::size_t last, std::size_t kept) {
    Result first = set;
    first.points.clear();
    first.classes.clear();
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        if (set.classes[i] > last && i >= kept) continue;
        first.points.push_back(set.points[i]);
        first.classes.push_back(set.classes[i]);
    }
    return first;
}

// The points of the first classes are a set of these alone, whichever class is the last.
inline void judge_priority(Made& made, const std::vector<std::string>& names, Random& random,
                           Counts& counts) {
    if (!may_have_stages(made)) return;
    Classes& classes = made.request.classes;
    classes.counts.clear();
    for (double& weight : classes.weights) weight = weight > 0 ? 1 : 0;
    classes.by_priority = true;
    const Answer answer = answer_of_all(made, names, counts);
    demand(answer.refusal.empty(), "by priority a request is refused: " + answer.refusal);
    judge_in_c(made, answer, counts);
    for (const Result& result : answer.sets) {
        const Set set{made.request,   result.points,
                      result.classes, made.request.field != nullptr ? result.scale : result.radius,
                      result.maximal, made.keep.size()};
        demand_proof(set, claim_of(set), "its order of classes", counts);
    }
    classes.by_priority = false;
    classes.weights.resize(classes.names.size(), 1);
    for (std::size_t last = classes.names.size(); last-- > 0;) {
        if (std::count(classes.weights.begin(), classes.weights.end(), 0) ==
            static_cast<std::ptrdiff_t>(classes.weights.size()))
            break;
        const bool is_kind =
            last + 1 == classes.names.size() || classes.names[last] != classes.names[last + 1];
        for (const Result& result : answer.sets)
            if (is_kind)
                judge_set(made, without_later(result, last, made.keep.size()), random, counts);
        classes.weights[last] = 0;
    }
}

}  // namespace lacuna::tests
