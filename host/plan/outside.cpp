// Kept points outside of the domain: which ones count, and a domain that holds them.
#include "plan/outside.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "checks/classes.h"
#include "checks/domain.h"
#include "plan/kept.h"
#include "plan/mask_tree.h"

namespace lacuna {
namespace {

// The margin of a mask has whole pixels, so its pixels are cut until this many lie along the longer
// side. Then the margin is only a little larger than the kept points need, and units stay fine.
constexpr double kPixels = 64;

// How long the domain with its margins may be, in shorter sides of the domain and in pixels of its
// mask. The shorter side then has 2^10 units of the grid or more, with 16 classes 2^8, and pixels
// can be counted.
constexpr double kMostSides = 0x1p20;
constexpr double kMostPixelsAround = 0x1p30;

// How far a point lies outside, along both axes.
Point way_out(const Domain& domain, Point point) {
    const auto along = [](double at, double low, double high) {
        return std::max({low - at, 0.0, at - high});
    };
    return {along(point.x, domain.x0, domain.x0 + domain.width),
            along(point.y, domain.y0, domain.y0 + domain.height)};
}

// The greatest distance that two points of the request keep. Infinite while it has no radius.
double reach_of(const Request& request) {
    if (!request.radius) return std::numeric_limits<double>::infinity();
    const std::vector<double> shares = distances_of(request.classes);
    return *request.radius * *std::max_element(shares.begin(), shares.end());
}

// The margins before and behind the domain along an axis, and the pixels of a mask in them.
struct Margins {
    double before = 0;
    double behind = 0;
    MaskTree::Padding pixels{};

    void round_to(double side, std::uint32_t count, double longer) {
        const double pixel = side / count;
        pixels.split =
            static_cast<std::uint32_t>(std::max(1.0, std::ceil(kPixels * pixel / longer)));
        const double part = pixel / pixels.split;
        pixels.before = static_cast<std::uint32_t>(std::ceil(before / part));
        pixels.behind = static_cast<std::uint32_t>(std::ceil(behind / part));
        before = pixels.before * part;
        behind = pixels.behind * part;
    }
};

// The masks of all classes have as many pixels (check_kept). Null if there is none.
const Mask* first_mask_of(const Request& request) {
    const Mask* first = mask_of(request, 0);
    for (std::size_t i = 1; first == nullptr && i < request.places.masks.size(); ++i)
        first = mask_of(request, i);
    return first;
}

void check_margins(const Domain& domain, const Mask* mask, const Margins& across,
                   const Margins& up) {
    double most = kMostSides * domain.shorter_side();
    if (mask != nullptr)
        most = std::min(most, kMostPixelsAround * std::min(domain.width / mask->columns,
                                                           domain.height / mask->rows));
    const double longer = std::max(across.before + domain.width + across.behind,
                                   up.before + domain.height + up.behind);
    if (!(longer <= most))
        throw BadRequest(
            "keep",
            "a point " + shortest(std::max({across.before, across.behind, up.before, up.behind})) +
                " outside",
            "is within the greatest distance, but with it the domain may be at most " +
                shortest(most) +
                " long: 2^20 times its shorter side, and 2^30 pixels of a mask or of polygons");
}

bool have_masks_as_many_pixels(const Request& request) {
    const Mask* const first = first_mask_of(request);
    for (std::size_t i = 0; i < request.places.masks.size(); ++i) {
        const Mask* const mask = mask_of(request, i);
        if (mask != nullptr && (mask->columns != first->columns || mask->rows != first->rows))
            return false;
    }
    return true;
}

Mask padded_mask(const Mask& mask, const MaskTree::Padding& across, const MaskTree::Padding& up,
                 const Poll& poll) {
    const auto own = mask.drawn ? std::shared_ptr<const MaskTree>(mask.drawn, &mask.drawn->tree)
                                : std::make_shared<const MaskTree>(mask, poll);
    DrawnMask drawn{MaskTree(*own, across, up, poll), {}, {}};
    Mask padded{drawn.tree.columns(), drawn.tree.rows(), {}, nullptr};
    padded.drawn = std::make_shared<const DrawnMask>(std::move(drawn));
    return padded;
}

}  // namespace

Members::Members(const Request& request)
    : domain_(request.domain),
      are_all_(std::all_of(request.keep.begin(), request.keep.end(),
                           [&](const Point& point) { return domain_.holds(point); })) {}

bool Members::has(Point kept) const {
    return domain_.holds(kept) && (are_all_ || (kept.x < domain_.x0 + domain_.width &&
                                                kept.y < domain_.y0 + domain_.height));
}

SortedKept sorted_kept(const Request& request) {
    const double reach = reach_of(request);
    const bool has_classes = !request.keep_classes.empty();
    const Members members(request);
    SortedKept sorted;
    sorted.has_radius = request.radius.has_value();
    for (const bool are_members : {true, false}) {
        for (std::size_t i = 0; i < request.keep.size(); ++i) {
            ask_after(1);
            const Point point = request.keep[i];
            if (members.has(point) != are_members) continue;
            const Point way = way_out(request.domain, point);
            if (!are_members && !(std::sqrt(way.x * way.x + way.y * way.y) <= reach)) continue;
            sorted.points.push_back(point);
            sorted.places.push_back(static_cast<std::uint32_t>(i));
            if (has_classes) sorted.classes.push_back(request.keep_classes[i]);
        }
        if (are_members) sorted.members = sorted.points.size();
    }
    return sorted;
}

void check_kept(const Request& request, const Members& members, std::size_t index) {
    const Point point = request.keep[index];
    const bool is_number = std::isfinite(point.x) && std::isfinite(point.y);
    if (members.has(point) || request.domain.wraps() || !is_number)
        return check_kept_place(request, index);
    const char* const with = request.field != nullptr              ? "a field"
                             : request.progressive                 ? "a progressive order"
                             : !have_masks_as_many_pixels(request) ? "masks of different sizes"
                                                                   : nullptr;
    if (with == nullptr) return;
    throw BadRequest(
        "keep",
        "point " + std::to_string(index) + " at (" + shortest(point.x) + ", " + shortest(point.y) +
            ")",
        std::string("with ") + with + " must lie in the domain, " + extent_of(request.domain, ']'));
}

Around around_kept(const Request& request, const Poll& poll) {
    const Domain& domain = request.domain;
    Margins across, up;
    for (const Point& point : request.keep) {
        across.before = std::max(across.before, domain.x0 - point.x);
        across.behind = std::max(across.behind, point.x - (domain.x0 + domain.width));
        up.before = std::max(up.before, domain.y0 - point.y);
        up.behind = std::max(up.behind, point.y - (domain.y0 + domain.height));
    }
    Around around{request, {}};
    const bool is_larger = across.before > 0 || across.behind > 0 || up.before > 0 || up.behind > 0;
    if (!is_larger) return around;
    const Mask* const first = first_mask_of(request);
    check_margins(domain, first, across, up);
    if (first != nullptr) {
        across.round_to(domain.width, first->columns, domain.longer_side());
        up.round_to(domain.height, first->rows, domain.longer_side());
    }
    std::map<const Mask*, const Mask*> padded{{nullptr, nullptr}};
    const auto pad = [&](const Mask* mask) {
        const auto [found, is_new] = padded.try_emplace(mask);
        if (is_new) {
            around.masks.push_back(padded_mask(*mask, across.pixels, up.pixels, poll));
            found->second = &around.masks.back();
        }
        return found->second;
    };
    std::vector<const Mask*>& of_classes = around.request.places.masks;
    for (std::size_t i = 0; i < of_classes.size(); ++i) of_classes[i] = pad(mask_of(request, i));
    if (of_classes.empty()) around.request.places.mask = pad(request.places.mask);
    Domain& larger = around.request.domain;
    larger.x0 -= across.before;
    larger.y0 -= up.before;
    larger.width += across.before + across.behind;
    larger.height += up.before + up.behind;
    return around;
}

}  // namespace lacuna
