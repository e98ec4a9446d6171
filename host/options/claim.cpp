// What a set of a request promises.
#include "options/claim.h"

namespace lacuna {
namespace {

// In mode lines x is interpolated in a strip, unless points are snapped to their lines.
double kept_distance(const Request& request, const Result& result) {
    if (request.mode != Mode::lines || request.paper2011.snap) return result.radius;
    return result.radius * (1 - 1 / (2.0 * result.lines_per_radius));
}

}  // namespace

Claim options::claim_of(const Request& request) {
    Claim claim;
    claim.radius = request.radius.value_or(0);
    claim.scale = request.scale.value_or(0);
    claim.domain = request.domain;
    claim.field = request.field;
    claim.places = request.places;
    claim.classes = request.classes;
    claim.keep = request.keep;
    claim.keep_classes = request.keep_classes;
    return claim;
}

Claim claim_of(const Request& request, const Result& result) {
    const bool is_of_distances = request.mode == Mode::stratified || request.mode == Mode::pixels;
    Claim claim = options::claim_of(is_of_distances ? Request{.domain = request.domain} : request);
    claim.radius = kept_distance(request, result);
    claim.distances_only = !result.maximal || request.mode != Mode::exact;
    if (is_of_distances) return claim;
    claim.scale = request.field != nullptr ? result.scale : 0;
    claim.places.edge = result.edge;
    claim.class_of_points = result.classes;
    return claim;
}

}  // namespace lacuna
