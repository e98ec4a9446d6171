// What a set of a request promises.
#include <lacuna/verify.h>

namespace lacuna {
namespace {

// In mode lines x is interpolated in a strip, unless points are snapped to their lines.
double kept_distance(const Request& request, const Result& result) {
    if (request.mode != Mode::lines || request.paper2011.snap) return result.radius;
    return result.radius * (1 - 1 / (2.0 * result.lines_per_radius));
}

}  // namespace

Claim claim_of(const Request& request, const Result& result) {
    Claim claim;
    claim.domain = request.domain;
    claim.radius = kept_distance(request, result);
    claim.distances_only = !result.maximal || request.mode != Mode::exact;
    if (request.mode == Mode::stratified || request.mode == Mode::pixels) return claim;
    claim.field = request.field;
    claim.scale = request.field != nullptr ? result.scale : 0;
    claim.places = request.places;
    claim.places.edge = result.edge;
    claim.mask = request.mask;
    claim.border = request.border;
    claim.classes = request.classes;
    claim.class_of_points = result.classes;
    claim.keep = request.keep;
    claim.keep_classes = request.keep_classes;
    return claim;
}

}  // namespace lacuna
