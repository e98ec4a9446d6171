// Checks the points that a request keeps: where they lie, and how far apart.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/number_text.h"
#include "base/polling.h"
#include "plan/corner.h"
#include "plan/ellipse.h"
#include "plan/kept.h"
#include "plan/mask_tree.h"
#include "plan/pixels_at.h"
#include "plan/sheets.h"

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
    if (mask.drawn) return mask.drawn->holds(point);
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

// Holds the points whose radius is at least `least`, in cells at least twice that wide. Points that
// keep their distance rarely share a cell, and the first two that are too close end the check.
class Cells {
public:
    Cells(const Request& request, std::span<const double> radii, double least)
        : request_(request),
          radii_(radii),
          columns_(cells_along(request.domain.width, 2 * least)),
          rows_(cells_along(request.domain.height, 2 * least)),
          next_(radii.size()) {}

    // A point that was added and is too close to this one.
    std::optional<std::uint32_t> too_close_to(std::uint32_t index) const {
        for (const std::uint64_t y : around(row_of(index), rows_))
            for (const std::uint64_t x : around(column_of(index), columns_))
                if (const auto other = too_close_in(x, y, index)) return other;
        return std::nullopt;
    }
    void add(std::uint32_t index) {
        const std::uint64_t cell = row_of(index) * columns_ + column_of(index);
        const auto [first, is_new] = first_.try_emplace(cell, index);
        next_[index] = is_new ? kNone : first->second;
        first->second = index;
    }

private:
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    // Cells are at least `side` wide. There are at most 2^30, which are narrower than any radius.
    static std::uint64_t cells_along(double length, double side) {
        return static_cast<std::uint64_t>(std::clamp(std::floor(length / side), 1.0, 0x1p30));
    }
    static std::uint64_t cell_of(double share, std::uint64_t cells) {
        const double at = std::max(0.0, share * static_cast<double>(cells));
        return at < static_cast<double>(cells) ? static_cast<std::uint64_t>(at) : cells - 1;
    }
    Point way_to(std::uint32_t index) const {
        return request_.domain.from_corner(request_.keep[index]);
    }
    std::uint64_t column_of(std::uint32_t index) const {
        return cell_of(way_to(index).x / request_.domain.width, columns_);
    }
    std::uint64_t row_of(std::uint32_t index) const {
        return cell_of(way_to(index).y / request_.domain.height, rows_);
    }
    // The cell and its neighbours, each once; on a torus across the edges, too.
    std::set<std::uint64_t> around(std::uint64_t cell, std::uint64_t cells) const {
        const bool wraps = request_.domain.wraps();
        std::set<std::uint64_t> near{cell};
        if (cell > 0 || wraps) near.insert((cell + cells - 1) % cells);
        if (cell + 1 < cells || wraps) near.insert((cell + 1) % cells);
        return near;
    }

    std::optional<std::uint32_t> too_close_in(std::uint64_t column, std::uint64_t row,
                                              std::uint32_t index) const {
        const auto first = first_.find(row * columns_ + column);
        if (first == first_.end()) return std::nullopt;
        for (std::uint32_t other = first->second; other != kNone; other = next_[other])
            if (are_too_close(other, index)) return other;
        return std::nullopt;
    }
    bool are_too_close(std::uint32_t a, std::uint32_t b) const {
        const Point way = way_between(request_, request_.keep[a], request_.keep[b]);
        if (!(length_of(way) < std::min(radii_[a], radii_[b]))) return false;
        if (request_.field == nullptr || request_.field->stretches.empty()) return true;
        return holds_way(request_, request_.keep[a], way) &&
               holds_way(request_, request_.keep[b], way);
    }

    const Request& request_;
    std::span<const double> radii_;
    std::uint64_t columns_;
    std::uint64_t rows_;
    std::unordered_map<std::uint64_t, std::uint32_t> first_;  // by cell: the last point added
    std::vector<std::uint32_t> next_;
};

// Between two polls 1024 points are looked up among the cells near them.
constexpr std::size_t kWorkOfPoint = kBetweenPolls / 1024;

struct Pair {
    std::uint32_t first;
    std::uint32_t second;
};

// Two of the points that are closer than the smaller of their radii: one that is `added`, and one
// that asks, which in one class are the same. If that radius lies in
// [2^l, 2^(l+1)), both have a radius of at least 2^l, and cells of width 2^(l+1) find the pair. So
// all points of at least 2^l are checked for each l.
std::optional<Pair> find_too_close(const Request& request, std::span<const double> radii,
                                   std::span<const std::uint32_t> added,
                                   std::span<const std::uint32_t> asking) {
    const bool is_one_class = added.data() == asking.data();
    std::set<int> levels;
    for (const std::uint32_t i : asking) levels.insert(std::ilogb(radii[i]));
    for (const std::uint32_t i : added) levels.insert(std::ilogb(radii[i]));
    for (const int level : levels) {
        const double least = std::ldexp(1.0, level);
        Cells cells(request, radii, least);
        for (const std::uint32_t i : is_one_class ? std::span<const std::uint32_t>() : added)
            if (ask_after(kWorkOfPoint); radii[i] >= least) cells.add(i);
        for (const std::uint32_t i : asking) {
            ask_after(kWorkOfPoint);
            if (radii[i] < least) continue;
            if (const auto other = cells.too_close_to(i)) return Pair{*other, i};
            if (is_one_class) cells.add(i);
        }
    }
    return std::nullopt;
}

std::vector<double> times(std::span<const double> radii, double factor) {
    std::vector<double> all(radii.begin(), radii.end());
    for (double& radius : all) radius *= factor;
    return all;
}

std::size_t class_of_kept(const Request& request, std::size_t index) {
    return request.classes.names.empty() ? 0 : request.keep_classes[index];
}

// Looks for two kept points that are too close, in each class and in each pair of classes. The
// points of the sparser class are put into the cells, so that few of them share one.
std::optional<Pair> find_too_close(const Request& request, std::span<const double> radii) {
    const std::vector<double> shares = distances_of(request);
    const std::size_t count = std::max<std::size_t>(request.classes.names.size(), 1);
    std::vector<std::vector<std::uint32_t>> of_class(count);
    for (std::uint32_t i = 0; i < radii.size(); ++i)
        of_class[class_of_kept(request, i)].push_back(i);
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = 0; b < count; ++b) {
            const double own_a = shares[a * (count + 1)], own_b = shares[b * (count + 1)];
            const bool is_sparser = own_a > own_b || (own_a == own_b && a <= b);
            const double share = shares[a * count + b];
            if (!is_sparser || share == 0) continue;
            const auto pair =
                find_too_close(request, times(radii, share), of_class[a], of_class[b]);
            if (pair) return pair;
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
        refuse(mask->drawn ? "must lie where --inside, --outside and --avoid allow it"
                           : "must lie where the mask is not 0");
    if (request.field != nullptr && greatest_importance_at(request, point) == 0)
        refuse("must lie where the field is not 0");
}

bool keep_their_distances(const Request& request) {
    return !find_too_close(request, radii_of_kept(request));
}

void check_kept_distances(const Request& request) {
    const double size = request.field == nullptr ? *request.radius : *request.scale;
    if (!std::isfinite(size) || size <= 0) return;  // the plan refuses such a size
    const std::vector<double> radii = radii_of_kept(request);
    const std::optional<Pair> pair = find_too_close(request, radii);
    if (!pair) return;
    const auto a = std::min(pair->first, pair->second), b = std::max(pair->first, pair->second);
    const bool has_classes = !request.classes.names.empty();
    const double share =
        distances_of(request)[class_of_kept(request, a) *
                                  std::max<std::size_t>(request.classes.names.size(), 1) +
                              class_of_kept(request, b)];
    throw BadRequest(
        "keep", text_of(a, request.keep[a]) + " and " + text_of(b, request.keep[b]),
        "are " + shortest(length_of(way_between(request, request.keep[a], request.keep[b]))) +
            " apart: must be at least " + shortest(std::min(radii[a], radii[b]) * share) +
            ", the " +
            (has_classes                ? "distance of their classes"
             : request.field == nullptr ? "radius"
                                        : "smaller of their radii"));
}

}  // namespace lacuna
