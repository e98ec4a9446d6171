// Judges the set of a request whose domain has been moved, with its kept points and polygons, to a
// corner at which coordinates lose digits.
#pragma once

#include <lacuna/domains.h>
#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "hostile/answers.h"
#include "hostile/counts.h"
#include "hostile/judge_set.h"
#include "hostile/made.h"

namespace lacuna::tests {

// In longer sides: from the least to the greatest that is allowed, and of few digits and many.
inline double any_corner(std::mt19937_64& random) {
    const double sign = random() % 2 == 0 ? 1 : -1;
    return sign * std::array{0.0, 1e-17, 0.1, 1.0, 3606.6, 0x1p20}[random() % 6];
}

// Adding the corner rounds kept points, so that they may be too close to each other, or to a
// border, and polygons, so that the last spot for a point of a count may be gone: then the request
// is refused, and there is nothing to judge.
inline void judge_elsewhere(const Made& made, const std::vector<std::string>& backends,
                            std::mt19937_64& random, Counts& counts) {
    Request request = made.request;
    Domain& domain = request.domain;
    domain.x0 = any_corner(random) * domain.longer_side();
    domain.y0 = any_corner(random) * domain.longer_side();
    const auto move = [&](Point& point) { point = {domain.x0 + point.x, domain.y0 + point.y}; };
    std::vector<Point> kept(made.all_kept);
    std::for_each(kept.begin(), kept.end(), move);
    request.keep = kept;
    std::vector<PolygonSet> sets(made.polygons);
    std::vector<std::vector<PolygonRing>> rings;
    for (const PolygonSet& set : sets) {
        rings.emplace_back(set.rings.begin(), set.rings.end());
        for (PolygonRing& ring : rings.back()) std::for_each(ring.begin(), ring.end(), move);
    }
    for (std::size_t i = 0; i < sets.size(); ++i) sets[i].rings = rings[i];
    const std::string at = "at the corner " + told(Point{domain.x0, domain.y0}) + " ";
    Mask mask;
    Result made_there;
    try {
        if (!sets.empty()) {
            mask = draw_places(sets, domain, made.edge);
            request.places.mask = &mask;
        }
        request.run_on.backend = backends[1 + random() % (backends.size() - 1)];
        made_there = sample(request);
    } catch (const BadRequest& error) {
        const std::string_view why = error.what();
        const bool has_no_spot = !sets.empty() && why.find("has no room") != why.npos;
        demand(has_no_spot || (!kept.empty() && error.option() == "keep"),
               at + "the request is refused: " + error.what());
        return;
    }
    for (const Point& point : made_there.points)
        demand(judge::contains(domain, point), at + told(point) + " lies outside");
    if (request.mode == Mode::stratified) return;
    const Set set{request,
                  made_there.points,
                  made_there.classes,
                  request.field != nullptr ? made_there.scale : made_there.radius,
                  made_there.maximal,
                  made.keep.size(),
                  sets,
                  made.edge};
    try {
        Claim claim = lacuna::claim_of(request, made_there);
        if (request.mode != Mode::exact) {
            demand(claim.distances_only && prove(made_there.points, claim).kept,
                   "its claim is refuted, or is of more than distances");
            return request.mode == Mode::pixels ? void() : judge_paper(set);
        }
        const std::string fault = set.judge().fault();
        demand(fault.empty(), fault);
        if (!sets.empty()) {
            claim.places.mask = nullptr;
            claim.places.outlines = places_of(sets, made.edge).outlines;
            claim.places.edge = made.edge;
        }
        if (set.points.size() < set.kept)
            claim.keep = claim.keep.first(set.points.size()),
            claim.keep_classes = {};  // a limit cuts them
        demand_proof(set, claim, "lacuna/verify.h", counts);
    } catch (const std::exception& error) {
        throw std::runtime_error(at + error.what());
    }
}

}  // namespace lacuna::tests
