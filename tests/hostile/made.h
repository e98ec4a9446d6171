// A request that was made from a row of levels, and all that it refers to.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "hostile/capabilities.h"

namespace lacuna::tests {

// A request and all that it refers to.
struct Made {
    Row row{};
    Request request;
    Field field{};
    Mask mask{};
    std::deque<std::vector<PolygonRing>> rings{};  // of the polygons
    std::vector<PolygonSet> polygons{};
    double edge = 0;
    std::deque<Mask> masks{};     // of classes
    std::vector<double> radii{};  // that give the distances of classes by sum or by union
    double frame = 0;             // the width of what tiles share
    std::vector<Point> keep{};    // in the domain
    std::vector<std::uint8_t> keep_classes{};
    std::vector<Point> neighbours{};  // outside
    std::vector<std::uint8_t> neighbour_classes{};
    std::vector<Point> all_kept{};  // what the request keeps: both
    std::vector<std::uint8_t> all_kept_classes{};
    std::vector<std::uint64_t> seeds{};  // the request's own is the first
    Field sparse{};                      // over which some of the points are relaxed, if not empty
    RelaxOptions moves{.iterations = 0};

    explicit Made(const Row& wanted) : row(wanted) {}
    Made(const Made&) = delete;
    Made& operator=(const Made&) = delete;
    bool is(Capability capability, std::string_view level) const {
        return is_level(kSampling, row, capability, level);
    }
    double least_distance() const {
        double least = std::numeric_limits<double>::infinity();
        for (const double distance : request.classes.distances)
            if (distance > 0) least = std::min(least, distance);
        return least;
    }
    // Sets the distances of classes, which are multiplied by a factor.
    void scale_classes(double by) {
        for (double& radius : radii) radius *= by;
        for (double& distance : request.classes.distances) distance *= by;
        if (is(kClasses, "sum") || is(kClasses, "sizes"))
            request.classes.distances = distances_by_sum(radii);
        if (is(kClasses, "union")) request.classes.distances = distances_by_union(radii);
    }
    bool is_moved() const { return moves.iterations != 0 || moves.gaussian != 0; }
    void keep_all() {
        all_kept = keep;
        all_kept.insert(all_kept.end(), neighbours.begin(), neighbours.end());
        all_kept_classes = keep_classes;
        all_kept_classes.insert(all_kept_classes.end(), neighbour_classes.begin(),
                                neighbour_classes.end());
        request.keep = all_kept;
        request.keep_classes = all_kept_classes;
    }
};

// The levels that a request has, which must be those of its row.
inline Row levels_of(const Made& made) {
    const Request& request = made.request;
    const auto level = [](auto number) { return static_cast<std::uint8_t>(number); };
    const double aspect = std::max(request.domain.width / request.domain.height,
                                   request.domain.height / request.domain.width);
    const auto has = [&](Role role) {
        return level(std::any_of(made.polygons.begin(), made.polygons.end(),
                                 [&](const PolygonSet& set) { return set.role == role; }));
    };
    Row row(kSampling.levels.size());
    row[kMode] = level(request.mode);
    row[kRadii] = request.field == nullptr ? 0 : request.field->stretches.empty() ? 1 : 2;
    row[kClasses] = request.classes.names.empty() ? 0 : made.row[kClasses];
    row[kMask] = !request.places.masks.empty()                             ? 2
                 : request.places.mask != nullptr && made.polygons.empty() ? 1
                                                                           : 0;
    row[kInside] = has(Role::inside);
    row[kOutside] = has(Role::outside);
    row[kAvoid] = has(Role::avoid);
    row[kNear] = has(Role::near);
    row[kBorder] = request.places.border > 0 ? 1 : 0;
    row[kKeep] = request.keep.empty() || made.frame > 0 ? 0 : made.neighbours.empty() ? 1 : 2;
    row[kEdges] = request.domain.wraps() ? 1 : 0;
    row[kDomain] = aspect > 3.1 ? 1 : 0;
    row[kSize] = request.count ? 1 : request.radius || request.scale ? 0 : 2;
    row[kOrder] = request.progressive ? 1 : 0;
    row[kLimit] = request.limit ? 1 : 0;
    row[kSeeds] = made.seeds.size() > 1 ? 1 : 0;
    row[kFrame] = made.frame > 0 ? 1 : 0;
    row[kThreads] = request.run_on.threads > 1 ? 1 : 0;
    row[kRounds] = request.paper2011.round_size == 0    ? 0
                   : request.paper2011.round_size == 1  ? 1
                   : request.paper2011.round_size <= 42 ? 2
                                                        : 3;
    row[kLines] = request.paper2011.lines_per_radius ? 1 : 0;
    row[kMetric] = level(request.metric);
    row[kPlacing] = request.paper2011.snap ? 1 : request.paper2011.uniform_x ? 2 : 0;
    row[kRelax] = made.moves.iterations == 0 ? 0 : made.sparse.importance.empty() ? 1 : 2;
    row[kGaussian] = made.moves.gaussian > 0 ? 1 : 0;
    return row;
}

// A message about the request. The seed and the number, not the message, make it again.
inline std::string describe(const Made& made) {
    const Request& request = made.request;
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::max_digits10);
    out << tests::describe(kSampling, made.row) << "; " << request.domain.width << "x"
        << request.domain.height;
    if (request.radius) out << ", radius " << *request.radius;
    if (request.scale) out << ", scale " << *request.scale;
    if (request.count) out << ", count " << *request.count;
    if (request.field != nullptr)
        out << ", field of " << made.field.columns << "x" << made.field.rows;
    if (request.places.mask != nullptr)
        out << ", mask of " << made.mask.columns << "x" << made.mask.rows;
    if (!request.classes.names.empty()) out << ", " << request.classes.names.size() << " classes";
    out << ", border " << request.places.border;
    for (const double border : request.places.borders) out << ":" << border;
    out << ", " << made.keep.size() << " kept, " << made.neighbours.size() << " outside, limit "
        << request.limit.value_or(0) << ", round size " << request.paper2011.round_size << ", m "
        << request.paper2011.lines_per_radius.value_or(0) << ", seed " << request.seed
        << ", threads " << request.run_on.threads;
    return out.str();
}

}  // namespace lacuna::tests
