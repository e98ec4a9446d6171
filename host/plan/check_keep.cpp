// Checks the points that a request keeps: where they lie, and how far apart.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "base/polling.h"
#include "checks/classes.h"
#include "checks/domain.h"
#include "plan/ellipse.h"
#include "plan/kept.h"
#include "plan/mask_tree.h"
#include "plan/pixels_at.h"

namespace lacuna {
namespace {

// Calls `use` with the index of every pixel on which the point may be said to lie.
template <class Use>
void for_pixels_at(const Request& request, Point point, std::uint32_t columns, std::uint32_t rows,
                   const Use& use) {
    lacuna::for_pixels_at(point, request.domain, columns, rows, use);
}

double greatest_importance_at(const Request& request, Point point) {
    const Field& field = *request.field;
    double greatest = 0;
    for_pixels_at(request, point, field.columns, field.rows, [&](std::size_t pixel) {
        greatest = std::max(greatest, field.importance[pixel]);
    });
    return greatest;
}

double radius_at(const Request& request, Point point) {
    if (request.field == nullptr) return *request.radius;
    return *request.scale / std::sqrt(greatest_importance_at(request, point));
}

// Calls `use` with each ellipse that a point may have.
template <class Use>
void for_ellipses_at(const Request& request, Point point, const Use& use) {
    const Field& field = *request.field;
    for_pixels_at(request, point, field.columns, field.rows, [&](std::size_t pixel) {
        const double radius = *request.scale / std::sqrt(field.importance[pixel]);
        if (std::isfinite(radius)) use(stretched(radius, field.stretches[pixel]));
    });
}

// The longest radius of the ellipses at a point, or that of its disk.
double longest_at(const Request& request, Point point) {
    double longest = radius_at(request, point);
    if (request.field == nullptr || request.field->stretches.empty()) return longest;
    for_ellipses_at(request, point,
                    [&](const Ellipse& ellipse) { longest = std::max(longest, ellipse.a); });
    return longest;
}

// Whether all ellipses at a point hold the way from it.
bool holds_way(const Request& request, Point point, Point way) {
    bool holds = true;
    for_ellipses_at(request, point,
                    [&](const Ellipse& ellipse) { holds &= form_of(ellipse).holds(way.x, way.y); });
    return holds;
}

bool is_allowed(const Request& request, const Mask& mask, Point point) {
    if (mask.drawn) return mask.drawn->keeps(point);
    bool allowed = false;
    for_pixels_at(request, point, mask.columns, mask.rows,
                  [&](std::size_t pixel) { allowed |= mask.allowed[pixel] != 0; });
    return allowed;
}

std::string text_of(std::size_t index, Point point) {
    return "point " + std::to_string(index) + " at (" + shortest(point.x) + ", " +
           shortest(point.y) + ")";
}

// The shortest way from a to b.
Point way_between(const Request& request, Point a, Point b) {
    const auto along = [&](double way, double length) {
        return request.domain.wraps() ? way - length * std::round(way / length) : way;
    };
    return {along(b.x - a.x, request.domain.width), along(b.y - a.y, request.domain.height)};
}

double length_of(Point way) {
    return std::sqrt(way.x * way.x + way.y * way.y);
}

// Kept points of one class in a tree of boxes, each halved along its longer side. So the search for
// points near a point takes few steps, wherever points lie and however much their distances differ.
class Tree {
public:
    Tree(const Request& request, std::span<const double> radii, std::vector<std::uint32_t> points)
        : request_(request), radii_(radii), points_(std::move(points)) {
        if (!points_.empty()) build(0, points_.size());
    }

    std::span<const std::uint32_t> points() const { return points_; }

    // Another point, in this tree, that is closer than `share` of the smaller of the two radii.
    std::optional<std::uint32_t> too_close_to(std::uint32_t index, double share) const {
        return nodes_.empty() ? std::nullopt : find(0, index, share);
    }

private:
    static constexpr std::size_t kFew = 8;         // points of a node that is not halved
    static constexpr std::size_t kWorkOfNode = 4;  // in pixels, for polls
    struct Node {
        Point low, high;      // the corners of the box around the points
        double greatest = 0;  // of the points' radii
        std::size_t begin = 0, end = 0;
        std::size_t second = 0;  // the second half; the first one follows the node. 0: not halved
    };

    std::size_t build(std::size_t begin, std::size_t end) {
        ask_after(end - begin);
        const Point first = request_.keep[points_[begin]];
        Node node{first, first, 0, begin, end};
        for (std::size_t i = begin; i < end; ++i) {
            const Point point = request_.keep[points_[i]];
            node.low = {std::min(node.low.x, point.x), std::min(node.low.y, point.y)};
            node.high = {std::max(node.high.x, point.x), std::max(node.high.y, point.y)};
            node.greatest = std::max(node.greatest, radii_[points_[i]]);
        }
        const std::size_t index = nodes_.size();
        nodes_.push_back(node);
        if (end - begin <= kFew) return index;
        const auto along =
            node.high.x - node.low.x > node.high.y - node.low.y ? &Point::x : &Point::y;
        const std::size_t middle = begin + (end - begin) / 2;
        const auto at = [&](std::size_t i) {
            return points_.begin() + static_cast<std::ptrdiff_t>(i);
        };
        std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
            return request_.keep[a].*along < request_.keep[b].*along;
        });
        build(begin, middle);
        const std::size_t second = build(middle, end);
        nodes_[index].second = second;
        return index;
    }

    // No point of the node is nearer: each step rounds in the same direction as way_between().
    double least_distance(const Node& node, Point at) const {
        const auto along = [&](double low, double high, double length) {
            const auto beyond = [&](double shift) {
                return std::max({low - shift, 0.0, shift - high});
            };
            return request_.domain.wraps() ? std::min({beyond(-length), beyond(0), beyond(length)})
                                           : beyond(0);
        };
        return length_of({along(node.low.x - at.x, node.high.x - at.x, request_.domain.width),
                          along(node.low.y - at.y, node.high.y - at.y, request_.domain.height)});
    }

    std::optional<std::uint32_t> find(std::size_t at, std::uint32_t index, double share) const {
        ask_after(kWorkOfNode);
        const Node& node = nodes_[at];
        if (!(least_distance(node, request_.keep[index]) <
              std::min(node.greatest, radii_[index]) * share))
            return std::nullopt;
        if (node.second != 0) {
            const auto other = find(at + 1, index, share);
            return other ? other : find(node.second, index, share);
        }
        for (std::size_t i = node.begin; i < node.end; ++i)
            if (points_[i] != index && are_too_close(points_[i], index, share)) return points_[i];
        return std::nullopt;
    }

    bool are_too_close(std::uint32_t a, std::uint32_t b, double share) const {
        const Point way = way_between(request_, request_.keep[a], request_.keep[b]);
        if (!(length_of(way) < std::min(radii_[a], radii_[b]) * share)) return false;
        if (request_.field == nullptr || request_.field->stretches.empty()) return true;
        return holds_way(request_, request_.keep[a], way) &&
               holds_way(request_, request_.keep[b], way);
    }

    const Request& request_;
    std::span<const double> radii_;
    std::vector<std::uint32_t> points_;
    std::vector<Node> nodes_;
};

struct Pair {
    std::uint32_t first;
    std::uint32_t second;
};

std::size_t class_of_kept(const Request& request, std::size_t index) {
    return request.classes.names.empty() ? 0 : request.keep_classes[index];
}

// Looks for two kept points that are too close, in each class and in each pair of classes.
std::optional<Pair> find_too_close(const Request& request, std::span<const double> radii) {
    const std::vector<double> shares = distances_of(request.classes);
    const std::size_t count = std::max<std::size_t>(request.classes.names.size(), 1);
    std::vector<std::vector<std::uint32_t>> of_class(count);
    for (std::uint32_t i = 0; i < radii.size(); ++i)
        of_class[class_of_kept(request, i)].push_back(i);
    std::vector<Tree> trees;
    trees.reserve(count);
    for (std::vector<std::uint32_t>& points : of_class)
        trees.emplace_back(request, radii, std::move(points));
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = a; b < count; ++b) {
            const double share = shares[a * count + b];
            if (share == 0) continue;
            for (const std::uint32_t i : trees[b].points())
                if (const auto other = trees[a].too_close_to(i, share)) return Pair{*other, i};
        }
    return std::nullopt;
}

}  // namespace

std::vector<double> radii_of_kept(const Request& request) {
    std::vector<double> radii;
    radii.reserve(request.keep.size());
    for_each_polled(request.keep.size(), ask,
                    [&](std::size_t i) { radii.push_back(longest_at(request, request.keep[i])); });
    return radii;
}

void check_kept_place(const Request& request, std::size_t index, const char* option) {
    const Point point = request.keep[index];
    const auto refuse = [&](const std::string& allowed) {
        throw BadRequest(option, text_of(index, point), allowed);
    };
    const Domain& domain = request.domain;
    if (!domain.holds(point))
        refuse("must lie in the domain, " + extent_of(domain, domain.wraps() ? ')' : ']'));
    const std::size_t of_class = class_of_kept(request, index);
    const double border = border_of(request, of_class);
    const Mask* const mask = mask_of(request, of_class);
    const Point way = domain.from_corner(point);
    if (way.x < border || domain.width - way.x < border || way.y < border ||
        domain.height - way.y < border)
        refuse("must be at least the border, " + shortest(border) + ", from the domain's edges");
    if (mask != nullptr && !is_allowed(request, *mask, point))
        refuse(mask->drawn ? "must lie where --inside, --outside, --avoid and --near allow it"
                           : "must lie where the mask is not 0");
    if (request.field != nullptr && greatest_importance_at(request, point) == 0)
        refuse("must lie where the field is not 0");
}

bool keep_their_distances(const Request& request) {
    return !find_too_close(request, radii_of_kept(request));
}

void check_kept_distances(const Request& request, std::span<const std::uint32_t> places) {
    const double size = request.field == nullptr ? *request.radius : *request.scale;
    if (!std::isfinite(size) || size <= 0) return;  // the plan refuses such a size
    const std::vector<double> radii = radii_of_kept(request);
    const std::optional<Pair> pair = find_too_close(request, radii);
    if (!pair) return;
    const auto a = std::min(pair->first, pair->second), b = std::max(pair->first, pair->second);
    const bool has_classes = !request.classes.names.empty();
    const double share =
        distances_of(request.classes)[class_of_kept(request, a) *
                                          std::max<std::size_t>(request.classes.names.size(), 1) +
                                      class_of_kept(request, b)];
    const auto named = [&](std::uint32_t index) {
        return text_of(places.empty() ? index : places[index], request.keep[index]);
    };
    throw BadRequest(
        "keep", named(a) + " and " + named(b),
        "are " + shortest(length_of(way_between(request, request.keep[a], request.keep[b]))) +
            " apart: must be at least " + shortest(std::min(radii[a], radii[b]) * share) +
            ", the " +
            (has_classes                ? "distance of their classes"
             : request.field == nullptr ? "radius"
                                        : "smaller of their radii"));
}

}  // namespace lacuna
