// The closest pair by divide and conquer (Shamos & Hoey 1975), then across the seams of a torus.
#include "verify/closest.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <vector>

namespace lacuna::verify {
namespace {

// A point, or an image of it beyond a seam.
struct Located {
    Point at;
    std::size_t index;
};

bool is_left(const Located& a, const Located& b) {
    return a.at.x < b.at.x;
}

bool is_below(const Located& a, const Located& b) {
    return a.at.y < b.at.y;
}

class ClosestPair {
public:
    ClosestPair(const Domain& domain, std::span<const Point> points, const Patience& patience)
        : domain_(domain), points_(points), patience_(patience) {}

    // Looks at all pairs of `located` that could be closer than the closest so far. `blur` is how
    // far the distance of two images may be off.
    void search(std::vector<Located> located, double blur) {
        blur_ = blur;
        std::sort(located.begin(), located.end(), patience_.looking(is_left));
        divide(located);
    }

    const Pair& closest() const { return closest_; }

private:
    static constexpr std::size_t kFewEnoughForAllPairs = 8;
    static constexpr std::size_t kFewEnoughToHurry = 1000;

    // Leaves `part` sorted by y.
    void divide(std::span<Located> part) {
        if (part.size() <= kFewEnoughForAllPairs) {
            std::sort(part.begin(), part.end(), is_below);
            compare_upwards(part);
            return;
        }
        if (part.size() > kFewEnoughToHurry) patience_.look();
        const std::size_t half = part.size() / 2;
        const double seam = part[half].at.x;
        divide(part.first(half));
        divide(part.subspan(half));
        buffer_.clear();
        std::merge(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half),
                   part.begin() + static_cast<std::ptrdiff_t>(half), part.end(),
                   std::back_inserter(buffer_), is_below);
        std::copy(buffer_.begin(), buffer_.end(), part.begin());
        buffer_.clear();
        for (const Located& located : part)
            if (is_within_reach(std::abs(located.at.x - seam))) buffer_.push_back(located);
        compare_upwards(buffer_);
    }

    void compare_upwards(std::span<const Located> rising) {
        for (std::size_t i = 0; i < rising.size(); ++i) {
            for (std::size_t j = i + 1; j < rising.size(); ++j) {
                if (!is_within_reach(rising[j].at.y - rising[i].at.y)) break;
                compare(rising[i].index, rising[j].index);
            }
        }
    }

    // Nothing is closer than 0: points that coincide would else be compared all with all.
    bool is_within_reach(double gap) const {
        return closest_.distance > 0 && gap <= closest_.distance + blur_;
    }

    void compare(std::size_t a, std::size_t b) {
        if (a == b) return;
        const Pair pair{std::min(a, b), std::max(a, b), domain_.distance(points_[a], points_[b])};
        if (std::tie(pair.distance, pair.first, pair.second) <
            std::tie(closest_.distance, closest_.first, closest_.second))
            closest_ = pair;
    }

    const Domain& domain_;
    std::span<const Point> points_;
    const Patience& patience_;
    double blur_ = 0;
    Pair closest_;
    std::vector<Located> buffer_;
};

// The points within `reach` of the domain's edges, and images of those on one side of a seam beyond
// those on the other: any pair that is closest across a seam is a pair of these.
std::vector<Located> near_seams(const Domain& domain, std::span<const Point> points, double reach) {
    std::vector<Located> located;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto [x, y] = points[i];
        const bool left = x <= reach;
        const bool low = y <= reach;
        const bool high = y >= domain.height - reach;
        if (left || low || high || x >= domain.width - reach) located.push_back({{x, y}, i});
        if (left) located.push_back({{x + domain.width, y}, i});
        if (low) located.push_back({{x, y + domain.height}, i});
        if (left && low) located.push_back({{x + domain.width, y + domain.height}, i});
        if (left && high) located.push_back({{x + domain.width, y - domain.height}, i});
    }
    return located;
}

}  // namespace

Pair closest_pair(const Domain& domain, std::span<const Point> points, const Patience& patience) {
    std::vector<Located> located(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) located[i] = {points[i], i};
    ClosestPair search(domain, points, patience);
    search.search(std::move(located), 0);
    const double distance = search.closest().distance;
    const double rounding = domain.rounding();
    // Points that are closer than rounding are the closest that a seam could show, too.
    if (domain.torus && points.size() > 1 && distance > rounding)
        search.search(near_seams(domain, points, distance + rounding), rounding);
    return search.closest();
}

}  // namespace lacuna::verify
