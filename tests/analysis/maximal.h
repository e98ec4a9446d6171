// Maximal Poisson-disk sets by squares that are halved until none is left (Ebeida et al. 2012):
// independent of Lacuna's samplers, with the distribution of dart throwing.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "analysis/sets.h"

namespace lacuna::analysis {

// On the unit torus; radius 1/4 at most.
class MaximalSet {
public:
    MaximalSet(double radius, std::uint64_t seed)
        : radius_(radius),
          random_(seed),
          cells_(static_cast<std::size_t>(1 / radius)),
          by_cell_(cells_ * cells_) {
        side_ = 1 / static_cast<double>(cells_);
        for (std::size_t i = 0; i < cells_; ++i)
            for (std::size_t j = 0; j < cells_; ++j)
                squares_.push_back(
                    {static_cast<double>(i) * side_, static_cast<double>(j) * side_});
        while (!squares_.empty()) {
            throw_darts();
            halve();
        }
    }

    std::vector<Point> take() { return std::move(points_); }

private:
    // Every square is equally likely, so darts are uniform over the space that may be free.
    void throw_darts() {
        const std::size_t darts = squares_.size();
        for (std::size_t i = 0; i < darts; ++i) {
            const auto chosen =
                static_cast<std::size_t>(uniform(random_) * static_cast<double>(squares_.size()));
            const Point corner = squares_[chosen];
            const Point dart{corner.x + side_ * uniform(random_),
                             corner.y + side_ * uniform(random_)};
            if (is_blocked(dart, 0)) continue;
            by_cell_[cell_of(dart)].push_back(dart);
            points_.push_back(dart);
        }
    }

    // Keeps the quarters that no single disk covers.
    void halve() {
        side_ /= 2;
        std::vector<Point> quarters;
        for (const Point& corner : squares_)
            for (const double dx : {0.0, side_})
                for (const double dy : {0.0, side_})
                    if (const Point quarter{corner.x + dx, corner.y + dy};
                        !is_blocked({quarter.x + side_ / 2, quarter.y + side_ / 2}, side_ / 2))
                        quarters.push_back(quarter);
        squares_ = std::move(quarters);
    }

    // Whether one disk covers the square around `centre` whose half side is `half`.
    bool is_blocked(Point centre, double half) const {
        const std::size_t cell = cell_of(centre);
        for (const std::size_t i : around(cell / cells_))
            for (const std::size_t j : around(cell % cells_))
                for (const Point& point : by_cell_[i * cells_ + j])
                    if (std::hypot(gap(point.x, centre.x) + half, gap(point.y, centre.y) + half) <
                        radius_)
                        return true;
        return false;
    }

    static double gap(double a, double b) {
        const double straight = std::abs(a - b);
        return std::min(straight, 1 - straight);
    }
    std::size_t cell_of(Point point) const {
        const auto along = [this](double at) {
            return static_cast<std::size_t>(at * static_cast<double>(cells_)) % cells_;
        };
        return along(point.x) * cells_ + along(point.y);
    }
    std::vector<std::size_t> around(std::size_t index) const {
        return {(index + cells_ - 1) % cells_, index, (index + 1) % cells_};
    }

    double radius_;
    Random random_;
    std::size_t cells_;  // cells along a side; each is at least as wide as the radius
    std::vector<std::vector<Point>> by_cell_;
    double side_ = 0;             // side of the squares
    std::vector<Point> squares_;  // their lower left corners
    std::vector<Point> points_;
};

inline std::vector<Point> maximal_set(double radius, std::uint64_t seed) {
    return MaximalSet(radius, seed).take();
}

}  // namespace lacuna::analysis
