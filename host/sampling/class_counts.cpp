// The loop over stages: each ends with the point that gives a class its number. Any prefix of a set
// is distributed as darts that were thrown until then, so nothing is lost by ending there. The last
// stage has the classes without a number.
#include "sampling/class_counts.h"

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
    std::vector<std::uint64_t> missing;
    for (const std::optional<std::uint64_t>& count : classes.counts)
        missing.push_back(count.value_or(kNoNumber));
    for (const std::uint8_t of_point : result.classes)
        if (classes.counts[of_point]) --missing[of_point];
    return missing;
}

bool is_full(std::uint64_t missing) {
    return missing == 0;
}
bool is_counted(std::uint64_t missing) {
    return missing != kNoNumber;
}

// The request with the classes that lack points of their number, or, if none does, with those that
// have no number.
CheckedRequest stage_of(const CheckedRequest& request, const std::vector<std::uint64_t>& missing) {
    const bool is_last = std::none_of(missing.begin(), missing.end(), [](std::uint64_t one) {
        return is_counted(one) && !is_full(one);
    });
    return request.with([&](Request& stage) {
        stage.classes.weights.resize(missing.size(), 1);
        for (std::size_t i = 0; i < missing.size(); ++i)
            if (is_full(missing[i]) || is_counted(missing[i]) == is_last)
                stage.classes.weights[i] = 0;
    });
}

void refuse_fewer(const std::vector<std::uint64_t>& missing, const Classes& classes) {
    for (std::size_t i = 0; i < missing.size(); ++i)
        if (classes.counts[i] && missing[i] != 0)
            throw BadRequest("class", classes.names[i],
                             "only " + std::to_string(*classes.counts[i] - missing[i]) +
                                 " of its " + std::to_string(*classes.counts[i]) +
                                 " points found room: ask for fewer");
}

}  // namespace

Result sample_with_counts(const CheckedRequest& request, Observer& observer, const Poll& poll) {
    const Classes& classes = request->classes;
    const double size = request->field != nullptr ? *request->scale : *request->radius;
    const FieldSize expected = check_radius_field_size(request, size, poll);
    Stages stages(request, observer, static_cast<std::uint64_t>(std::min(expected.samples, 1e18)));
    Result& result = stages.result();
    std::vector<std::uint64_t> missing = missing_in(result, classes);
    do {
        stages.run(stage_of(request, missing), poll, missing);
        missing = missing_in(result, classes);
    } while (!result.maximal);
    refuse_fewer(missing, classes);
    result.maximal = has_open_class(classes);
    return std::move(result);
}

}  // namespace lacuna
