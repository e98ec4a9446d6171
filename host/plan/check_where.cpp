// Checks a request's mask and border.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/number_text.h"
#include "base/polling.h"
#include "checks/classes.h"
#include "checks/domain.h"
#include "checks/pixels.h"
#include "plan/checked_request.h"
#include "plan/kept.h"
#include "plan/mask_tree.h"

namespace lacuna {
namespace {

// A border that leaves a place for points.
void check_border_of(const Domain& domain, double border, const std::string& value) {
    const double half = domain.shorter_side() / 2;
    if (!(border >= 0 && border < half))
        throw BadRequest(
            "border", value,
            "must be at least 0 and under half of the domain's shorter side, " + shortest(half));
    check_border(domain, border, value);
}

void check_places_of_classes(const Request& request) {
    const std::vector<double>& borders = request.places.borders;
    const std::vector<const Mask*>& masks = request.places.masks;
    check_each(request.classes, "border", borders.size(), " borders of classes");
    check_each(request.classes, "mask", masks.size(), " masks of classes");
    for (std::size_t i = 0; i < borders.size(); ++i)
        check_border_of(request.domain, borders[i],
                        request.classes.names[i] + ":" + shortest(borders[i]));
    for (const Mask* mask : masks)
        if (mask != nullptr) check_mask(*mask);
}

}  // namespace

bool allows_some(const Mask& mask) {
    if (mask.drawn) {
        const MaskTree& tree = mask.drawn->tree;
        return tree.over({0, tree.columns() - 1}, {0, tree.rows() - 1}) != ALLOWED_NONE;
    }
    bool is_zero = true;
    for_each_polled(mask.allowed.size(), ask,
                    [&](std::size_t i) { is_zero &= mask.allowed[i] == 0; });
    return !is_zero;
}

bool has_places(const Request& request) {
    for (std::size_t i = 0; i < std::max<std::size_t>(request.classes.names.size(), 1); ++i)
        if (const Mask* mask = mask_of(request, i); mask == nullptr || allows_some(*mask))
            return true;
    return false;
}

void check_where(const Request& request) {
    const std::string mode = "with mode " + std::string(name_of(request.mode));
    const bool exact = request.mode == Mode::exact;
    if (request.places.mask != nullptr && !exact && request.mode != Mode::pixels)
        throw BadRequest("mask", mode, "is for modes exact and pixels");
    if (request.places.border != 0 && !exact)
        throw BadRequest("border", mode, "is for mode exact only");
    if (!request.keep.empty() && !exact) throw BadRequest("keep", mode, "is for mode exact only");
    if (request.places.mask != nullptr) check_mask(*request.places.mask);
    check_border_of(request.domain, request.places.border, shortest(request.places.border));
    check_places_of_classes(request);
    if (request.count && *request.count > 0 && !has_places(request))
        throw BadRequest("count", std::to_string(*request.count),
                         "points may lie nowhere in the domain, " + extent_of(request.domain, ')') +
                             ": must be a set without --count");
    const Members members(request);
    std::uint64_t kept = 0;
    for_each_polled(request.keep.size(), ask, [&](std::size_t i) {
        check_kept(request, members, i);
        kept += members.has(request.keep[i]) ? 1U : 0U;
    });
    if (request.count && !request.progressive && *request.count < kept)
        throw BadRequest("count", std::to_string(*request.count),
                         "must be at least " + std::to_string(kept) +
                             ", the number of kept points, which count");
}

}  // namespace lacuna
