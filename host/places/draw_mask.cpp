// Draws polygons onto a mask.
//
// The code does not use cairo. Which pixels lie inside must be the same on every machine and with
// every version of a library; cairo rounds corners to 1/256 of a pixel and draws at most 32,767
// pixels a side.
#include <lacuna/places.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "base/polling.h"
#include "checks/domain.h"
#include "checks/numbers.h"
#include "places/draw_tree.h"
#include "places/fair.h"
#include "plan/mask_tree.h"
#include "plan/sizes.h"

namespace lacuna {
namespace {

// The least edge, in lengths of the longer side. It is a sixteenth of the least radius
// (kSmallestRadius), and makes at most 2^25 pixels a side.
constexpr double kLeastEdge = 0x1p-24;
// By how much samplers may round the borders of a pixel, in lengths of the longer side.
constexpr double kBorderRounding = 0x1p-26;

// The number of pixels at which a pixel's diagonal, with what its borders are rounded by, is at
// most `edge`.
double pixels_along(double length, double edge, double longer) {
    return std::max(1.0, std::ceil(length * std::sqrt(2.0) / (edge - longer * kBorderRounding)));
}

places::Canvas canvas_of(const Domain& domain, double edge) {
    check_domain(domain);
    check_positive("edge", edge);
    const double longer = domain.longer_side();
    if (edge < longer * kLeastEdge)
        throw BadRequest("edge", shortest(edge),
                         "must be at least " + rounded(1.01 * longer * kLeastEdge, 2) +
                             ", the longer side / 2^24");
    const auto along = [&](double length) {
        return static_cast<std::uint32_t>(pixels_along(length, edge, longer));
    };
    return {domain, along(domain.width), along(domain.height)};
}

[[noreturn]] void refuse_memory(double edge, const std::string& what, double most_bytes,
                                double coarser) {
    throw BadRequest("edge", shortest(edge),
                     "takes a mask of " + what + ", of which " + rounded(most_bytes / 1e9, 3) +
                         " GB are allowed: must be coarser, such as " + rounded(coarser, 2));
}

struct Extent {
    Point least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Point most{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    void add(std::span<const PolygonRing> rings, double reach) {
        for (const PolygonRing& ring : rings)
            for (const Point& point : ring) {
                least = {std::min(least.x, point.x - reach), std::min(least.y, point.y - reach)};
                most = {std::max(most.x, point.x + reach), std::max(most.y, point.y + reach)};
            }
    }
    // Whether a domain whose corner is 0, 0 is at most twice as wide and high as needed.
    bool begins_near_0() const {
        return least.x >= 0 && least.y >= 0 && least.x <= most.x - least.x &&
               least.y <= most.y - least.y;
    }
    std::string text() const {
        const auto side = [](double from, double to) {
            return "[" + rounded(from, 10) + ", " + rounded(to, 10) + "]";
        };
        return side(least.x, most.x) + " x " + side(least.y, most.y);
    }
};

void check(const PolygonSet& set) {
    check_at_least_0("border", set.distance);
    for (std::size_t i = 0; i < set.rings.size(); ++i)
        for (const Point& point : set.rings[i])
            if (ask_after(); !places::is_fair(point))
                throw BadRequest(std::string(name_of(set.role)), "ring " + std::to_string(i),
                                 "(" + shortest(point.x) + ", " + shortest(point.y) +
                                     "): " + std::string(places::kFair));
}

// What a mask needs of the sets once they are drawn.
std::shared_ptr<const DrawnMask> drawn(std::span<const PolygonSet> sets,
                                       const places::Canvas& canvas, MaskTree tree) {
    struct Owned {
        std::vector<std::vector<PolygonRing>> rings;
        std::vector<PolygonSet> sets;
    };
    const auto owned = std::make_shared<Owned>();
    for (const PolygonSet& set : sets)
        owned->rings.emplace_back(set.rings.begin(), set.rings.end());
    for (const PolygonSet& set : sets)
        owned->sets.push_back({owned->rings[owned->sets.size()], set.role, set.distance});
    const auto mask = std::make_shared<DrawnMask>(DrawnMask{std::move(tree), {}, {}});
    const MaskTree* const pixels = &mask->tree;
    const auto holds = [owned, pixels, canvas](Point at, bool may_touch) {
        const auto pixel = [](double share, std::uint32_t count) {
            return static_cast<std::uint32_t>(std::clamp(share * count, 0.0, count - 1.0));
        };
        // Only near edges a pixel does not decide.
        const Domain& domain = canvas.domain;
        const Point way = domain.from_corner(at);
        return pixels->at(pixel(way.x / domain.width, canvas.columns),
                          pixel(way.y / domain.height, canvas.rows)) != ALLOWED_NONE ||
               places::allow(owned->sets, at, may_touch);
    };
    mask->holds = [holds](Point at) { return holds(at, false); };
    mask->keeps = [holds](Point at) { return holds(at, true); };
    return mask;
}

// The box itself, or a larger square with the same corner if the box is so small and so far from 0
// that its corner would be refused. The square's side is a power of two.
Domain large_enough(Domain box) {
    constexpr double kSpare = 1.01;  // for sums of corner and side, which are rounded
    const double least = kSpare * std::max(std::abs(box.x0), std::abs(box.y0)) / kFarthestCorner;
    if (box.longer_side() * kSpare >= least) return box;
    int exponent = 0;
    std::frexp(least, &exponent);
    box.width = box.height = std::ldexp(1, exponent);
    return box;
}

}  // namespace

Domain domain_around(const Places& places, const Field* field) {
    if (field != nullptr) return domain_like(field->columns, field->rows);
    const auto shape_of = [](const Mask& mask) {
        return mask.extent ? *mask.extent : domain_like(mask.columns, mask.rows);
    };
    const auto decides = [&](const Mask* mask) {
        return mask != nullptr && (mask->extent || places.outlines.empty());
    };
    if (decides(places.mask)) return shape_of(*places.mask);
    for (const Mask* const mask : places.masks)
        if (decides(mask)) return shape_of(*mask);
    Extent all;
    for (const Outline& outline : places.outlines) {
        if (outline.polygons.page) return *outline.polygons.page;
        check({outline.polygons.rings, outline.role, outline.distance.value_or(0)});
        all.add(outline.polygons.rings,
                outline.role == Role::near ? outline.distance.value_or(0) : 0);
    }
    if (all.least.x >= 0 && all.least.y >= 0 && all.most.x <= 1 && all.most.y <= 1) return {};
    if (all.begins_near_0()) return {all.most.x, all.most.y};
    const Domain box{.width = all.most.x - all.least.x,
                     .height = all.most.y - all.least.y,
                     .x0 = all.least.x,
                     .y0 = all.least.y};
    if (box.shorter_side() > 0) return large_enough(box);
    throw BadRequest("domain", "missing",
                     "the places given lie in " + all.text() +
                         ", which has no area: give a domain that has one");
}

Mask draw_places(std::span<const PolygonSet> sets, const Domain& domain, double edge,
                 std::uint64_t memory_limit_bytes) {
    const places::Canvas canvas = canvas_of(domain, edge);
    for (const PolygonSet& set : sets) check(set);
    const std::uint64_t most =
        memory_limit_bytes != 0 ? memory_limit_bytes : machine_memory_bytes() / 4;
    std::optional<MaskTree> tree =
        places::draw_tree(sets, canvas, static_cast<std::size_t>(most / sizeof(MaskTree::Node)));
    if (!tree) refuse_memory(edge, "more memory", static_cast<double>(most), 2 * edge);
    return {canvas.columns, canvas.rows, {}, drawn(sets, canvas, std::move(*tree))};
}

Mask draw_mask(std::span<const PolygonRing> rings, const Domain& domain, double edge,
               std::uint64_t memory_limit_bytes) {
    const PolygonSet only{rings};
    return draw_mask(std::span(&only, 1), domain, edge, memory_limit_bytes);
}

Mask draw_mask(std::span<const PolygonSet> sets, const Domain& domain, double edge,
               std::uint64_t memory_limit_bytes) {
    const places::Canvas canvas = canvas_of(domain, edge);
    const auto most = static_cast<double>(memory_limit_bytes != 0 ? memory_limit_bytes
                                                                  : machine_memory_bytes() / 4);
    const double bytes = static_cast<double>(canvas.columns) * canvas.rows;
    if (bytes > most)  // 1 % more than needed, because both numbers of pixels are rounded up
        refuse_memory(edge,
                      std::to_string(canvas.columns) + " x " + std::to_string(canvas.rows) +
                          " pixels, " + rounded(bytes / 1e9, 3) + " GB",
                      most, edge * 1.01 * std::sqrt(bytes / most));
    Mask mask = draw_places(sets, domain, edge, memory_limit_bytes);
    mask.allowed.resize(std::size_t{mask.columns} * mask.rows);
    mask.drawn->tree.for_each_allowed(
        [&](std::uint32_t column, std::uint32_t row, std::uint32_t columns, std::uint32_t rows) {
            for (std::uint32_t i = row; i < row + rows; ++i)
                std::fill_n(&mask.allowed[std::size_t{mask.rows - 1 - i} * mask.columns + column],
                            columns, std::uint8_t{1});
        });
    mask.drawn = nullptr;
    return mask;
}

}  // namespace lacuna
