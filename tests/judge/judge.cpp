// What the judge knows of points and spots: their shapes, limits and room.
#include "judge/judge.h"

#include <algorithm>
#include <cmath>

namespace lacuna::judge {

double Shape::length_of(Point way) const {
    if (shorter == 0) return kInfinity;
    if (xx == 0) return std::sqrt(way.x * way.x + way.y * way.y) / shorter;
    return std::sqrt(xx * way.x * way.x + 2 * xy * way.x * way.y + yy * way.y * way.y);
}

double Shape::over(Point way, double f) const {
    if (xx == 0) return std::sqrt(way.x * way.x + way.y * way.y) - f * shorter;
    return shorter * (length_of(way) - f);
}

Judge::Judge(const Request& request, std::span<const Point> points,
             std::span<const std::uint8_t> classes, double size,
             std::span<const PolygonSet> polygons, double edge)
    : request_(request),
      domain_(request.domain),
      size_(size),
      polygons_(polygons),
      edge_(edge),
      own_(points.size()) {
    const std::vector<double>& distances = request.classes.distances;
    for (const double distance : distances)
        if (distance > 0) least_distance_ = std::min(least_distance_, distance);
    if (distances.empty()) least_distance_ = 1;
    for (const double distance : distances)
        greatest_ = std::max(greatest_, distance / least_distance_);
    // Where there are points outside of a box, those on its upper edges are outside, too.
    const auto is_outside = [&](Point at) { return !contains(domain_, at); };
    const bool has_neighbours = std::any_of(request.keep.begin(), request.keep.end(), is_outside);
    const auto is_neighbour = [&](Point at) {
        return has_neighbours && !contains(domain_, at, true);
    };
    const auto kept = static_cast<std::size_t>(
        std::count_if(request.keep.begin(), request.keep.end(), std::not_fn(is_neighbour)));
    for (std::size_t i = 0; i < own_; ++i)
        sites_.push_back({points[i], shapes_near(points[i]),
                          classes.empty() ? std::uint8_t{0} : classes[i], i < kept});
    double left = domain_.x0, right = left + domain_.width;
    double bottom = domain_.y0, top = bottom + domain_.height;
    for (std::size_t i = 0; i < request.keep.size(); ++i) {
        const Point at = request.keep[i];
        if (!is_neighbour(at)) continue;
        const auto& of_kept = request.keep_classes;
        const std::uint8_t kind = of_kept.empty() ? std::uint8_t{0} : of_kept[i];
        const Point in{std::clamp(at.x, domain_.x0, domain_.x0 + domain_.width),
                       std::clamp(at.y, domain_.y0, domain_.y0 + domain_.height)};
        const bool is_far = std::hypot(at.x - in.x, at.y - in.y) > greatest_ * size;
        sites_.push_back({at, {Shape{size, size}}, kind, true, is_far});
        if (is_far) continue;
        left = std::min(left, at.x), right = std::max(right, at.x);
        bottom = std::min(bottom, at.y), top = std::max(top, at.y);
    }
    longer_side_ = std::max(right - left, top - bottom);
}

double Judge::blur() const {
    return std::max(domain_.width, domain_.height) * 0x1p-28;
}

bool Judge::is_uniform() const {
    return request_.field == nullptr && request_.places.mask == nullptr && request_.keep.empty() &&
           request_.places.border == 0 && request_.classes.names.empty() && polygons_.empty();
}

double Judge::tolerance() const {
    const std::size_t count = request_.classes.names.size();
    return (is_uniform() ? 1 : 2) * longer_side_ * 0x1p-28 * greatest_ *
           (count <= 4   ? 1
            : count <= 8 ? 2
                         : 4);
}

std::size_t Judge::kinds() const {
    return std::max<std::size_t>(1, request_.classes.names.size());
}

double Judge::border(std::uint8_t kind) const {
    const std::vector<double>& own = request_.places.borders;
    return own.empty() ? request_.places.border : own[kind];
}

const Mask* Judge::mask_of(std::uint8_t kind) const {
    const std::vector<const Mask*>& own = request_.places.masks;
    const Mask* const mask = own.empty() || own[kind] == nullptr ? request_.places.mask : own[kind];
    return mask == nullptr || mask->allowed.empty() ? nullptr : mask;
}

double Judge::factor(std::uint8_t a, std::uint8_t b) const {
    if (request_.classes.names.empty()) return 1;
    return request_.classes.distances[a * kinds() + b] / least_distance_;
}

bool Judge::is_drawn(std::uint8_t kind) const {
    const Classes& classes = request_.classes;
    return (classes.weights.empty() || classes.weights[kind] != 0) &&
           (classes.counts.empty() || !classes.counts[kind]);
}

bool Judge::is_in_mask(Point at, std::uint8_t kind) const {
    const Mask* const mask = mask_of(kind);
    return mask == nullptr || mask->allowed[pixel_of(domain_, mask->columns, mask->rows, at)] != 0;
}

std::optional<Shape> Judge::shape_at(Point at) const {
    const Field* const field = request_.field;
    if (field == nullptr) return Shape{size_, size_};
    const std::size_t pixel = pixel_of(domain_, field->columns, field->rows, at);
    if (field->importance[pixel] == 0) return std::nullopt;
    const double radius = size_ / std::sqrt(field->importance[pixel]);
    if (field->stretches.empty()) return Shape{radius, radius};
    const auto [ratio, angle] = field->stretches[pixel];
    const double longer = radius * std::sqrt(ratio), shorter = radius / std::sqrt(ratio);
    const double c = std::cos(angle), s = std::sin(angle);
    const double far = 1 / (longer * longer), near = 1 / (shorter * shorter);
    return Shape{shorter, longer, c * c * far + s * s * near, c * s * (far - near),
                 s * s * far + c * c * near};
}

// The point, and those beside it on whose pixels it may count as lying. Sums with coordinates of
// the corner are rounded.
std::vector<Point> Judge::near(Point at) const {
    std::vector<Point> all;
    const double far = blur() + 0x1p-51 * std::max(std::abs(domain_.x0), std::abs(domain_.y0));
    for (const double dx : {0.0, -far, far})
        for (const double dy : {0.0, -far, far})
            all.push_back(wrapped(domain_, {at.x + dx, at.y + dy}));
    return all;
}

std::vector<Shape> Judge::shapes_near(Point at) const {
    if (request_.field == nullptr) return {Shape{size_, size_}};
    std::vector<std::size_t> seen;
    std::vector<Shape> shapes;
    for (const Point one : near(at)) {
        const std::size_t pixel =
            pixel_of(domain_, request_.field->columns, request_.field->rows, one);
        if (std::find(seen.begin(), seen.end(), pixel) != seen.end()) continue;
        seen.push_back(pixel);
        if (const auto shape = shape_at(one)) shapes.push_back(*shape);
    }
    return shapes;
}

// A kept point may lie on the upper edges of a box, too.
bool Judge::is_allowed(const Site& site) const {
    const double edge = border(site.kind) - (border(site.kind) > 0 ? blur() : 0);
    if (!contains(domain_, site.at, !site.is_kept) || to_edges(domain_, site.at) < edge)
        return false;
    const std::vector<Point> all = near(site.at);
    return std::any_of(all.begin(), all.end(),
                       [&](Point one) { return is_in_mask(one, site.kind); }) &&
           !site.shapes.empty();
}

bool Judge::is_open(Point spot, std::uint8_t kind) const {
    const double near = 4 * blur();
    if (!contains(domain_, spot) ||
        to_edges(domain_, spot) < border(kind) + (border(kind) > 0 ? near : 0))
        return false;
    const Mask* const mask = mask_of(kind);
    if (!shape_at(spot) || !is_in_mask(spot, kind)) return false;
    if (!polygons_.empty() && depth_in(polygons_, spot) <= edge_ + near) return false;
    const auto is_another = [&](const auto* pixels, Point there) {
        return pixels != nullptr && pixel_of(domain_, pixels->columns, pixels->rows, there) !=
                                        pixel_of(domain_, pixels->columns, pixels->rows, spot);
    };
    for (const double dx : {-near, near})
        for (const double dy : {-near, near}) {
            const Point there{spot.x + dx, spot.y + dy};
            if (is_another(request_.field, there) || is_another(mask, there)) return false;
        }
    return true;
}

// With each pair of shapes the two must be too close.
double Judge::share_of(const Site& a, const Site& b) const {
    double f = factor(a.kind, b.kind);
    if (f == 0 || a.shapes.empty() || b.shapes.empty()) return kInfinity;
    if (request_.mode == Mode::lines && !request_.paper2011.snap)
        f = (1 - 0.5 / request_.paper2011.lines_per_radius.value_or(30)) * (1 - 1e-12);
    const Point step = way(domain_, a.at, b.at);
    double share = 0;
    for (const Shape& one : a.shapes)
        for (const Shape& other : b.shapes)
            share = std::max({share, one.length_of(step) / f, other.length_of(step) / f});
    return share;
}

double Judge::share_of(std::size_t i, std::size_t j) const {
    return share_of(sites_[i], sites_[j]);
}

Judge::Closest Judge::closest() const {
    Closest closest;
    for (std::size_t j = 0; j < sites_.size(); ++j)
        for (std::size_t i = 0; i < std::min(j, own_); ++i)
            if (const double share = share_of(i, j); share < closest.share && !sites_[j].is_far)
                closest = {i, j, share};
    return closest;
}

std::optional<std::size_t> Judge::astray() const {
    for (std::size_t i = 0; i < own_; ++i)
        if (!is_allowed(sites_[i])) return i;
    return std::nullopt;
}

std::string Judge::fault() const {
    const auto text = [&](std::size_t i) {
        return "point " + std::to_string(i) + " at " + text_of(sites_[i].at);
    };
    if (const auto point = astray()) return text(*point) + " lies where no point may";
    const Closest pair = closest();
    if (pair.share >= 1) return "";
    return text(pair.first) + " and " + text(pair.second) + " are too close";
}

double Judge::over(const Site& site, Point spot, const Shape& own, std::uint8_t kind) const {
    const double f = factor(site.kind, kind);
    if (f == 0) return kInfinity;
    const Point step = way(domain_, site.at, spot);
    // An ellipse may reach a spot of a torus by a longer way than the straight one.
    const int images = own.xx != 0 && domain_.boundary == Boundary::torus ? 1 : 0;
    double least = kInfinity;
    for (const Shape& shape : site.shapes)
        for (int i = -images; i <= images; ++i)
            for (int k = -images; k <= images; ++k) {
                const Point by{step.x + i * domain_.width, step.y + k * domain_.height};
                least = std::min(least, std::max(shape.over(by, f), own.over(by, f)));
            }
    return least;
}

double Judge::room(Point spot, std::uint8_t kind) const {
    const std::optional<Shape> own = shape_at(spot);
    if (!own) return -kInfinity;
    double least = kInfinity;
    for (const Site& site : sites_)
        if (!site.is_far) least = std::min(least, over(site, spot, *own, kind));
    return least;
}

}  // namespace lacuna::judge
