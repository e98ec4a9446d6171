// Judges the sets of a request of classes once more, with a number of points for one of them.
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
#include "hostile/judge_set.h"
#include "hostile/made.h"

namespace lacuna::tests {

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
    if (kinds < 2 || made.frame > 0 || request.count || request.limit || request.progressive)
        return;
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

}  // namespace lacuna::tests
