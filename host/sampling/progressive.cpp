// The loop over levels. Each is a run of the ordinary rounds, whose plan keeps all samples of the
// levels before.
#include "sampling/progressive.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/power.h"
#include "plan/checked_request.h"
#include "plan/kept.h"
#include "plan/radius_field.h"
#include "plan/sizes.h"
#include "sampling/generate.h"
#include "sampling/stages.h"

namespace lacuna {
namespace {

// The radii, or with a field the scales, of all levels.
class Sizes {
public:
    // With a radius or scale asked for, the last level has exactly that.
    Sizes(const Request& request, const Poll& poll)
        : first_(radius_field_scale_for_count(request, kFirstPoints, poll)) {
        const std::optional<double>& asked = request.field ? request.scale : request.radius;
        if (!asked) return;
        last_ = std::max(
            0, static_cast<int>(std::ceil(kLevelsPerHalving * std::log2(first_ / *asked))));
        first_ = *asked / shrunk(last_);
        size_of_last_ = *asked;  // the product is rounded
    }

    double at(int level) const { return is_last(level) ? size_of_last_ : first_ * shrunk(level); }
    bool is_last(int level) const { return level == last_; }

private:
    static double shrunk(int levels) {
        return power(0.5, static_cast<double>(levels) / kLevelsPerHalving);
    }

    double first_;
    double size_of_last_ = 0;
    int last_ = std::numeric_limits<int>::max();
};

// The radius or scale asked for, or expected at the last of `count` points.
double size_at_the_end(const Request& request, const Poll& poll) {
    if (request.count)
        return radius_field_scale_for_count(request, static_cast<double>(*request.count), poll);
    return request.field != nullptr ? *request.scale : *request.radius;
}

// A level of the request.
CheckedRequest at_size(const CheckedRequest& request, double size) {
    return request.with([&](Request& level) {
        (level.field != nullptr ? level.scale : level.radius) = size;
        if (level.count) level.limit = std::min(*level.count, level.limit.value_or(*level.count));
        level.count.reset();
    });
}

// The length of the longest ellipse of a torus at a scale of 1; 0 if any length fits.
double longest_ellipse(const Request& request) {
    double longest = 0;
    if (!request.domain.wraps() || request.field == nullptr) return longest;
    const Field& field = *request.field;
    for (std::size_t i = 0; i < field.stretches.size(); ++i)
        if (field.importance[i] > 0)
            longest =
                std::max(longest, 2 * std::sqrt(field.stretches[i].ratio / field.importance[i]));
    return longest;
}

// The first level at which ellipses fit on a torus, and points that the request keeps are not too
// close together. Throws BadRequest if these are at the last level, or at the smallest radius that
// there can be.
int first_level(const CheckedRequest& request, const Sizes& sizes) {
    const double smallest = kSmallestRadius * request->domain.longer_side();
    const double longest = longest_ellipse(request);
    const double most = request->domain.shorter_side() * (1 - 1e-6);  // they are rounded
    for (int level = 0;; ++level) {
        const bool is_last = sizes.is_last(level) || sizes.at(level) < smallest;
        if (!is_last && longest * sizes.at(level) > most) continue;
        const CheckedRequest at_level = at_size(request, sizes.at(level));
        if (keep_their_distances(at_level)) return level;
        if (is_last) check_kept_distances(at_level, at_level.places_of_kept());
    }
}

}  // namespace

Result progressive(const CheckedRequest& request, Observer& observer, const Poll& poll) {
    const Sizes sizes(request, poll);
    const FieldSize last = check_radius_field_size(request, size_at_the_end(request, poll), poll);
    const std::optional<std::uint64_t> limit = at_size(request, sizes.at(0))->limit;
    const auto most = static_cast<std::uint64_t>(std::min(last.samples, 1e18));
    Stages stages(request, observer, std::min(most, limit.value_or(most)));
    Result& result = stages.result();
    for (int level = first_level(request, sizes);; ++level) {
        stages.run(at_size(request, sizes.at(level)), poll);
        const bool is_whole = result.maximal;
        if (is_whole) result.levels.push_back({sizes.at(level), result.points.size()});
        if (is_whole && !sizes.is_last(level)) continue;
        if (limit) cut_points(std::min<std::size_t>(result.points.size(), *limit), result);
        return std::move(result);
    }
}

}  // namespace lacuna
