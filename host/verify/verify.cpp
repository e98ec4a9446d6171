// What makes a proof, and which questions make no sense.
#include "verify/verify.h"

#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "base/threads.h"

namespace lacuna::verify {
namespace {

constexpr double kSmallestSide = 1e-100;
constexpr double kLargestSide = 1e100;
constexpr double kLargestAspect = 1000;
void check_lengths(double radius, double tolerance, double longer) {
    if (!std::isfinite(radius) || radius <= 0)
        throw BadRequest("radius", text(radius), "must be a finite number greater than 0");
    if (radius < longer * kSmallestRadius)
        throw BadRequest("radius", text(radius),
                         "must be at least " + text(longer * kSmallestRadius) +
                             ", the longer side / 2^32, or doubles run out of digits");
    check_tolerance(tolerance);
}

// Refuses what makes no sense, and looks for a point outside.
Verdict begin(std::span<const Point> points, const Domain& domain, double radius,
              double tolerance) {
    check_domain(domain.width, domain.height);
    check_lengths(radius, tolerance, domain.longer_side());
    Verdict verdict;
    const auto outside = std::find_if(points.begin(), points.end(),
                                      [&](const Point& p) { return !domain.contains(p); });
    if (outside != points.end())
        verdict.outside = static_cast<std::size_t>(outside - points.begin());
    return verdict;
}

}  // namespace

std::string text(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return {digits.data(), end};
}

void check_tolerance(double tolerance) {
    if (!std::isfinite(tolerance) || tolerance < 0)
        throw BadRequest("tolerance", text(tolerance), "must be a finite number of at least 0");
}

void check_domain(double width, double height) {
    const std::string domain = text(width) + "x" + text(height);
    const double shorter = std::min(width, height);
    const double longer = std::max(width, height);
    if (!std::isfinite(width) || !std::isfinite(height) || shorter <= 0)
        throw BadRequest("domain", domain, "both sides must be finite numbers greater than 0");
    if (shorter < kSmallestSide || longer > kLargestSide)
        throw BadRequest("domain", domain, "the sides must lie between 1e-100 and 1e100");
    if (longer > kLargestAspect * shorter)
        throw BadRequest("domain", domain, "the longer side may be at most 1000 times the shorter");
}

double default_tolerance(double width, double height) {
    return std::max(width, height) * 0x1p-28;
}

Verdict check(std::span<const Point> points, double width, double height, bool torus, double radius,
              double tolerance, const Patience& patience) {
    const Domain domain{width, height, torus};
    Verdict verdict = begin(points, domain, radius, tolerance);
    if (verdict.outside) return verdict;
    const double limit = radius + tolerance;
    make_sure_of_threads();
    oneapi::tbb::parallel_invoke(
        [&] { verdict.closest = closest_pair(domain, points, patience); },
        [&] { verdict.emptiest = emptiest_spot(domain, points, limit, patience); });
    verdict.kept = verdict.closest.distance >= radius;
    verdict.covered = verdict.emptiest.distance <= limit + domain.rounding();
    return verdict;
}

Verdict check_distances(std::span<const Point> points, double width, double height, bool torus,
                        double radius, const Patience& patience) {
    const Domain domain{width, height, torus};
    Verdict verdict = begin(points, domain, radius, 0);
    if (verdict.outside) return verdict;
    verdict.closest = closest_pair(domain, points, patience);
    verdict.kept = verdict.closest.distance >= radius;
    return verdict;
}

}  // namespace lacuna::verify
