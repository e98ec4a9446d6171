// lacuna::tile_ring: what tiles have in common, so that any two fit side by side.
//
// Let R be the greatest distance of two points, and D the width of the frame. Without the points
// farther than D from the edges there is room only farther than D - R from them, as only those
// points covered spots there. So new points of two tiles are at least 2 (D - R) apart, and a spot
// of one tile is at least as far from the new points of the next. If D is at least 1.5 R, this is
// at least R: nothing that differs from tile to tile has an effect beyond the edges. There each
// tile is as in the torus of the first set.
#include <lacuna/many.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "base/number_text.h"
#include "checks/classes.h"
#include "plan/checked_request.h"

namespace lacuna {
namespace {

constexpr double kLeastWidth = 1.5;  // of a frame, in greatest distances
// A covered spot may be farther than the least distance by 2^-27 of the longer side, or with 16
// classes by 2^-25, and as a multiple of that than a greater one. So the frame is a little wider
// than asked for.
constexpr double kRounding = 0x1p-23;

// The greatest distance that two points keep.
double greatest_distance(const Request& request) {
    const double share = greatest_share(request.classes);
    if (request.field == nullptr) return share * *request.radius;
    const Field& field = *request.field;
    double greatest = 0;
    for (std::size_t i = 0; i < field.importance.size(); ++i) {
        const double ratio = field.stretches.empty() ? 1 : field.stretches[i].ratio;
        if (field.importance[i] > 0)
            greatest = std::max(greatest, std::sqrt(ratio / field.importance[i]));
    }
    return greatest * share * *request.scale;
}

void refuse_others(const Request& request) {
    const auto refuse = [](const std::string& with, const char* why) {
        throw BadRequest("frame", with, why);
    };
    if (!request.domain.wraps()) refuse("on a box", "is for a torus, whose edges wrap");
    if (request.mode != Mode::exact)
        refuse("with mode " + std::string(name_of(request.mode)), "is for mode exact");
    if (request.count) refuse("with --count", "each set would have a radius of its own");
    if (request.limit) refuse("with a limit", "sets that have gaps leave them between tiles, too");
    if (has_counts(request.classes))
        refuse("with numbers of points of classes", "there would be room at the edges of tiles");
    if (request.progressive) refuse("with a progressive order", "the frame would come first");
    if (!request.keep.empty()) refuse("with kept points", "the frame's points are kept");
}

void check_width(const Request& request, double width) {
    const double least = kLeastWidth * greatest_distance(request);
    if (!(least > 0) || std::isinf(least)) return;  // sample() refuses such a radius
    const double half = request.domain.shorter_side() / 2;
    constexpr double kWritten = 1 - 1e-9;  // as least is written in the message
    if (width >= kWritten * least && width < half) return;
    if (kWritten * least >= half)
        throw BadRequest("frame", shortest(width),
                         "1.5 times the greatest distance of two points, " + rounded(least, 10) +
                             ", must be under half of the domain's shorter side, " +
                             shortest(half) + ": give a smaller radius or a larger domain");
    throw BadRequest("frame", shortest(width),
                     "must be at least " + rounded(least, 10) +
                         ", 1.5 times the greatest distance of two points, and under half of the "
                         "domain's shorter side, " +
                         shortest(half));
}

}  // namespace

TileRing tile_ring(const Request& request, double width) {
    Observer nobody;
    return tile_ring(request, width, nobody);
}

TileRing tile_ring(const Request& request, double width, Observer& observer) {
    refuse_others(request);
    const CheckedRequest checked(request);
    check_width(checked, width);
    const Result first = sample(request, observer);
    const Domain& domain = request.domain;
    const double most = width + kRounding * greatest_share(checked->classes) * domain.longer_side();
    TileRing frame;
    for (std::size_t i = 0; i < first.points.size(); ++i) {
        const Point way = domain.from_corner(first.points[i]);
        if (std::min({way.x, domain.width - way.x, way.y, domain.height - way.y}) > most) continue;
        frame.points.push_back(first.points[i]);
        if (!first.classes.empty()) frame.classes.push_back(first.classes[i]);
    }
    return frame;
}

}  // namespace lacuna
