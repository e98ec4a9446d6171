// Checks a domain, and writes it.
#include "checks/domain.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/number_text.h"
#include "base/polling.h"

namespace lacuna {
namespace {

// The largest coordinate along an axis if sums are rounded there.
double farthest(double corner, double side) {
    return corner == 0 ? 0 : std::max(std::abs(corner), std::abs(corner + side));
}

}  // namespace

void check_domain(const Domain& domain) {
    constexpr double kLargestAspect = 1000;
    const double shorter = domain.shorter_side(), longer = domain.longer_side();
    const auto refuse = [&](const std::string& allowed) {
        throw BadRequest("domain", text_of(domain), allowed);
    };
    if (!std::isfinite(domain.width) || !std::isfinite(domain.height) || !(shorter > 0))
        refuse("both sides must be finite numbers greater than 0");
    if (longer > kLargestAspect * shorter)
        refuse("the longer side may be at most " + shortest(kLargestAspect) + " times the shorter");
    if (shorter < 1e-100 || longer > 1e100) refuse("the sides must lie between 1e-100 and 1e100");
    if (!std::isfinite(domain.x0) || !std::isfinite(domain.y0))
        refuse("the corner must be two finite numbers");
    const double most = kFarthestCorner * longer;
    if (std::max(std::abs(domain.x0), std::abs(domain.y0)) > most)
        refuse("the corner may be at most " + shortest(most) +
               " from 0 along either axis, 2^20 times the longer side, or doubles run out of "
               "digits");
}

void check_border(const Domain& domain, double border, const std::string& value) {
    if (!std::isfinite(border) || border < 0)
        throw BadRequest("border", value, "must be a finite number of at least 0");
    if (border > 0 && domain.wraps())
        throw BadRequest("border", value, "is not for a torus, which has no edges");
}

double lost_at_corner(const Domain& domain) {
    // Each coordinate of both points is off by at most 2^-53 of the largest one.
    // Not std::hypot, whose last bit differs between systems.
    const double x = farthest(domain.x0, domain.width), y = farthest(domain.y0, domain.height);
    return 0x1p-52 * std::sqrt(x * x + y * y);
}

std::vector<Point> from_corner(std::span<const Point> points, const Domain& domain) {
    std::vector<Point> ways(points.size());
    for_each_polled(points.size(), ask,
                    [&](std::size_t i) { ways[i] = domain.from_corner(points[i]); });
    return ways;
}

std::string text_of(const Domain& domain) {
    const std::string sides = shortest(domain.width) + "x" + shortest(domain.height);
    if (!domain.has_corner()) return sides;
    return shortest(domain.x0) + "," + shortest(domain.y0) + "+" + sides;
}

std::string text_of(const Raster& raster) {
    return std::to_string(raster.columns) + "x" + std::to_string(raster.rows);
}

std::string corner_text(double x0, double y0) {
    if (x0 == 0 && y0 == 0) return "";
    return " at (" + shortest(x0) + ", " + shortest(y0) + ")";
}

std::string extent_of(const Domain& domain, char end) {
    std::string text;
    const auto add = [&](double low, double high) {
        text.append("[").append(shortest(low)).append(", ").append(shortest(high)) += end;
    };
    add(domain.x0, domain.x0 + domain.width);
    text += " x ";
    add(domain.y0, domain.y0 + domain.height);
    return text;
}

}  // namespace lacuna
