// The loop over stages. A stage ends with the point that gives a class its number. Any prefix of a
// set is distributed as darts that were thrown until then, so nothing is lost by ending there. The
// last stage has the classes without a number. By priority each class has a stage of its own, which
// ends with its number or when no point of it has room.
#include "sampling/class_stages.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "checks/classes.h"
#include "plan/sizes.h"
#include "sampling/stages.h"

namespace lacuna {
namespace {

constexpr std::uint64_t kNoNumber = std::numeric_limits<std::uint64_t>::max();

// How many points each class still lacks.
std::vector<std::uint64_t> missing_in(const Result& result, const Classes& classes) {
    std::vector<std::uint64_t> missing(classes.names.size(), kNoNumber);
    for (std::size_t i = 0; i < classes.counts.size(); ++i)
        missing[i] = classes.counts[i].value_or(kNoNumber);
    for (const std::uint8_t of_point : result.classes)
        if (missing[of_point] != kNoNumber) --missing[of_point];
    return missing;
}

bool is_full(std::uint64_t missing) {
    return missing == 0;
}
bool is_counted(std::uint64_t missing) {
    return missing != kNoNumber;
}

// The request in which the others of the classes that may have more points are not drawn.
template <class IsDrawn>
CheckedRequest stage_of(const CheckedRequest& request, const std::vector<std::uint64_t>& missing,
                        const IsDrawn& is_drawn) {
    return request.with([&](Request& stage) {
        stage.classes.weights.resize(missing.size(), 1);
        for (std::size_t i = 0; i < missing.size(); ++i)
            if (is_full(missing[i]) || !is_drawn(i)) stage.classes.weights[i] = 0;
    });
}

// The classes that lack points of their number or, if none does, those that have no number.
CheckedRequest next_by_count(const CheckedRequest& request,
                             const std::vector<std::uint64_t>& missing) {
    const bool is_last = std::none_of(missing.begin(), missing.end(), [](std::uint64_t one) {
        return is_counted(one) && !is_full(one);
    });
    return stage_of(request, missing,
                    [&](std::size_t i) { return is_counted(missing[i]) != is_last; });
}

void refuse_fewer(const std::vector<std::uint64_t>& missing, const Classes& classes) {
    for (std::size_t i = 0; i < missing.size(); ++i)
        if (is_counted(missing[i]) && missing[i] != 0)
            throw BadRequest("class", classes.names[i],
                             "only " + std::to_string(*classes.counts[i] - missing[i]) +
                                 " of its " + std::to_string(*classes.counts[i]) +
                                 " points found room: ask for fewer");
}

}  // namespace

Result sample_in_stages(const CheckedRequest& request, Observer& observer, const Poll& poll) {
    const Classes& classes = request->classes;
    const double size = request->field != nullptr ? *request->scale : *request->radius;
    const FieldSize expected = check_radius_field_size(request, size, poll);
    Stages stages(request, observer, static_cast<std::uint64_t>(std::min(expected.samples, 1e18)));
    Result& result = stages.result();
    const auto missing = [&] { return missing_in(result, classes); };
    const auto run = [&](const auto& stage_with) {
        const std::vector<std::uint64_t> lacking = missing();
        stages.run(stage_with(lacking), poll, lacking);
    };
    for (std::size_t i = 0; classes.by_priority && i < classes.names.size();) {
        const KindOfClass kind = kind_of(classes, i);
        const auto is_next = [&](std::size_t one) { return one >= kind.first && one <= kind.last; };
        const auto is_finished = [&] {
            const std::vector<std::uint64_t> lacking = missing();
            return result.maximal ||
                   std::all_of(lacking.begin() + static_cast<std::ptrdiff_t>(kind.first),
                               lacking.begin() + static_cast<std::ptrdiff_t>(kind.last + 1),
                               is_full);
        };
        do run([&](const auto& lacking) { return stage_of(request, lacking, is_next); });
        while (!is_finished());
        i = kind.last + 1;
    }
    while (!classes.by_priority) {
        run([&](const auto& lacking) { return next_by_count(request, lacking); });
        if (result.maximal) break;
    }
    refuse_fewer(missing(), classes);
    result.maximal = has_open_class(classes);
    return std::move(result);
}

}  // namespace lacuna
