// The closest pair by divide and conquer (Shamos & Hoey 1975), then across the edges of a torus.
//
// Radii may differ, and are the longer ones of ellipses. Let q be the ratio of the closest pair
// found until now. Two samples are a closer pair only if their distance is at most q times the
// radius of either of them. So each sample has its own reach, q times its radius. Within a half
// that was searched, samples of similar radius are at least their reach apart, so a strip along the
// cut has few of them near any sample.
#include "verify/closest.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <tuple>
#include <vector>

namespace lacuna::verify {
namespace {

// A sample, or an image of it beyond an edge of a torus.
struct Located {
    Point at;
    double radius;
    std::size_t index;
};

bool is_left(const Located& a, const Located& b) {
    return a.at.x < b.at.x;
}

bool is_below(const Located& a, const Located& b) {
    return a.at.y < b.at.y;
}

// The distance and the limit of two samples.
Pair measured(const Domain& domain, const Disk& a, const Disk& b) {
    Pair pair{.distance = domain.distance(a.at, b.at), .limit = std::min(a.radius, b.radius)};
    pair.ratio = pair.distance / pair.limit;
    return pair;
}

Pair measured(const Domain& domain, const BlurredEllipse& a, const BlurredEllipse& b) {
    const Point way = domain.way(a.at, b.at);
    Pair pair{.distance = std::sqrt(way.x * way.x + way.y * way.y),
              .limit = std::numeric_limits<double>::infinity(),
              .ratio = 0};
    for (const auto& shapes : {a.shapes, b.shapes})
        for (const EllipseShape* shape : shapes) {
            pair.limit = std::min(pair.limit, shape->radius_along(way));
            pair.ratio = std::max(pair.ratio, shape->length_of(way) / shape->shorter);
        }
    return pair;
}

template <typename Sample>
class ClosestPair {
public:
    ClosestPair(const Domain& domain, std::span<const Sample> samples, const Patience& patience)
        : domain_(domain), samples_(samples), patience_(patience) {}

    // Looks at all pairs of `located` that could be closer than the closest pair found until now.
    // `blur` is the largest error of the distance between two images.
    void search(std::vector<Located> located, double blur) {
        blur_ = blur;
        std::sort(located.begin(), located.end(), patience_.looking(is_left));
        divide(located);
    }

    const Pair& closest() const { return closest_; }

    // The largest distance to another sample at which this one could be in a closer pair. Its last
    // factor is for the roundings of ratios.
    double reach_of(double radius) const { return closest_.ratio * radius * (1 + 1e-12); }

private:
    // Up to this number of samples, comparing all pairs is faster than halving.
    static constexpr std::size_t kFewEnoughForAllPairs = 8;
    // Up to this number of samples, the search takes too little time to ask whether it is wanted.
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
        const double cut = part[half].at.x;
        divide(part.first(half));
        divide(part.subspan(half));
        buffer_.clear();
        std::merge(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half),
                   part.begin() + static_cast<std::ptrdiff_t>(half), part.end(),
                   std::back_inserter(buffer_), is_below);
        std::copy(buffer_.begin(), buffer_.end(), part.begin());
        buffer_.clear();
        for (const Located& located : part)
            if (is_within_reach(located, std::abs(located.at.x - cut))) buffer_.push_back(located);
        compare_upwards(buffer_);
    }

    void compare_upwards(std::span<const Located> rising) {
        for (std::size_t i = 0; i < rising.size(); ++i) {
            for (std::size_t j = i + 1; j < rising.size(); ++j) {
                if (!is_within_reach(rising[i], rising[j].at.y - rising[i].at.y)) break;
                compare(rising[i].index, rising[j].index);
            }
        }
    }

    // No pair is closer than 0. Without this rule, samples that coincide would all be compared with
    // each other.
    bool is_within_reach(const Located& located, double gap) const {
        return closest_.distance > 0 && gap <= reach_of(located.radius) + blur_;
    }

    void compare(std::size_t a, std::size_t b) {
        if (a == b) return;
        Pair pair = measured(domain_, samples_[a], samples_[b]);
        std::tie(pair.first, pair.second) = std::minmax(a, b);
        if (std::tie(pair.ratio, pair.first, pair.second) <
            std::tie(closest_.ratio, closest_.first, closest_.second))
            closest_ = pair;
    }

    const Domain& domain_;
    std::span<const Sample> samples_;
    const Patience& patience_;
    double blur_ = 0;
    Pair closest_;
    std::vector<Located> buffer_;
};

// The samples within reach of the domain's edges, and their images beyond the opposite edges, from
// the domain's corner on. If the closest pair of a torus lies across an edge, it is a pair of
// these.
template <typename Sample>
std::vector<Located> near_edges(const Domain& domain, std::span<const Sample> samples,
                                const ClosestPair<Sample>& search) {
    std::vector<Located> located;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto [x, y] = domain.from_corner(samples[i].at);
        const double radius = samples[i].radius;
        const double reach = search.reach_of(radius) + domain.rounding();
        const bool left = x <= reach;
        const bool low = y <= reach;
        const bool high = y >= domain.height - reach;
        const auto append = [&](double at_x, double at_y) {
            located.push_back({{at_x, at_y}, radius, i});
        };
        if (left || low || high || x >= domain.width - reach) append(x, y);
        if (left) append(x + domain.width, y);
        if (low) append(x, y + domain.height);
        if (left && low) append(x + domain.width, y + domain.height);
        if (left && high) append(x + domain.width, y - domain.height);
    }
    return located;
}

template <typename Sample>
Pair least_ratio(const Domain& domain, std::span<const Sample> samples, const Patience& patience) {
    std::vector<Located> located(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
        located[i] = {samples[i].at, samples[i].radius, i};
    ClosestPair<Sample> search(domain, samples, patience);
    search.search(std::move(located), 0);
    // Across an edge, distances have errors of up to rounding(): no closer pair can be found there.
    if (domain.torus && samples.size() > 1 && search.closest().distance > domain.rounding())
        search.search(near_edges(domain, samples, search), domain.rounding());
    return search.closest();
}

// Sorts the samples from the largest radius to the smallest, finds the shortest prefix that has a
// pair with a ratio below `hopeless`, and returns the closest pair of that prefix.
template <typename Sample>
Pair first_hopeless(const Domain& domain, std::span<const Sample> samples, const Patience& patience,
                    double hopeless) {
    std::vector<std::size_t> order(samples.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return samples[a].radius > samples[b].radius;
    });
    std::vector<Sample> walk;
    walk.reserve(samples.size());
    for (const std::size_t index : order) walk.push_back(samples[index]);
    const auto closest_of = [&](std::size_t count) {
        return least_ratio(domain, std::span<const Sample>(walk).first(count), patience);
    };
    std::size_t without = 1;
    std::size_t with = walk.size();
    while (with - without > 1) {
        const std::size_t middle = without + (with - without) / 2;
        (closest_of(middle).ratio < hopeless ? with : without) = middle;
    }
    Pair pair = closest_of(with);
    std::tie(pair.first, pair.second) = std::minmax({order[pair.first], order[pair.second]});
    return pair;
}

template <typename Sample>
Pair closest_pair_of(const Domain& domain, std::span<const Sample> samples,
                     const Patience& patience, double hopeless) {
    const Pair pair = least_ratio(domain, samples, patience);
    return pair.ratio < hopeless ? first_hopeless(domain, samples, patience, hopeless) : pair;
}

}  // namespace

Pair closest_pair(const Domain& domain, std::span<const Disk> samples, const Patience& patience,
                  double hopeless) {
    return closest_pair_of(domain, samples, patience, hopeless);
}

Pair closest_pair(const Domain& domain, std::span<const BlurredEllipse> samples,
                  const Patience& patience, double hopeless) {
    return closest_pair_of(domain, samples, patience, hopeless);
}

Pair closest_pair(const Domain& domain, std::span<const Point> points, const Patience& patience) {
    std::vector<Disk> samples;
    samples.reserve(points.size());
    for (const Point& point : points) samples.push_back({point, 1});
    return closest_pair(domain, std::span<const Disk>(samples), patience);
}

}  // namespace lacuna::verify
