// A random request with the levels of a row: from one point to some hundred, in domains, on radii,
// masks and polygons of every hostile kind.
#pragma once

#include <lacuna/domains.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "hostile/hard_points.h"
#include "hostile/made.h"
#include "hostile/random_parts.h"
#include "judge/judge.h"
#include "plan/checked_request.h"

namespace lacuna::tests {

class RandomRequest {
public:
    RandomRequest(std::uint64_t seed, std::uint64_t number, const Row& row)
        : choose_(seed, number), row_(row) {}

    // Tries again where nothing is allowed. A row that is refused is made without a trial.
    std::unique_ptr<Made> make(bool is_refused) {
        constexpr int kTries = 200;
        for (int i = 0; i < kTries; ++i) {
            auto made = std::make_unique<Made>(row_);
            if (try_to_make(*made, is_refused)) return made;
        }
        throw std::runtime_error("no request of this row has room: " +
                                 tests::describe(kSampling, row_));
    }

private:
    bool is(Capability capability, std::string_view level) const {
        return is_level(kSampling, row_, capability, level);
    }

    bool try_to_make(Made& made, bool is_refused) {
        Request& request = made.request;
        constexpr std::array kModes{Mode::exact, Mode::lines, Mode::cells, Mode::stratified,
                                    Mode::pixels};
        constexpr std::array kMetrics{Metric::min, Metric::mean, Metric::max};
        request.mode = kModes[row_[kMode]];
        request.metric = kMetrics[row_[kMetric]];
        request.domain.boundary = is(kEdges, "torus") ? Boundary::torus : Boundary::box;
        request.paper2011.snap = is(kPlacing, "snap");
        request.paper2011.uniform_x = is(kPlacing, "uniform-x");
        request.progressive = is(kOrder, "progressive");
        request.seed = choose_.random()();
        made.seeds = {request.seed};
        if (is(kSeeds, "several")) made.seeds.push_back(choose_.random()());
        request.run_on.threads = is(kThreads, "one") ? 1 : 2 + choose_.below(3);
        if (is(kRounds, "of one")) request.paper2011.round_size = 1;
        if (is(kRounds, "small")) request.paper2011.round_size = 2 + choose_.below(40);
        if (is(kRounds, "large"))
            request.paper2011.round_size = static_cast<std::uint64_t>(choose_.power(50, 3e4));
        choose_domain(request);
        choose_radii(made);
        if (is(kMask, "yes")) {
            made.mask = random_mask(choose_);
            request.places.mask = &made.mask;
        }
        if (is(kMask, "of classes")) choose_masks(made);
        if (has_polygons() && !choose_polygons(made)) return false;
        const auto border = [&] {
            return request.domain.shorter_side() / 2 *
                   std::array{1e-9, choose_.in(0, 0.5), 1 - 1e-3}[choose_.below(3)];
        };
        if (is(kBorder, "yes")) request.places.border = border();
        if (is(kBorder, "yes") && choose_.one_in(2))
            for (std::size_t i = 0; i < request.classes.names.size(); ++i)
                request.places.borders.push_back(choose_.one_in(4) ? 0 : border());
        if (is(kMode, "pixels")) {
            request.on_pixels = {1 + choose_.below(300), 1 + choose_.below(300)};
            if (!is_refused && !has_spare_pixels(request)) return false;
        }
        choose_moves(made);
        Result trial;
        if (is_refused) {
            // The only kept point must not be what is refused.
            if (!is(kKeep, "no") && !is_open_in_the_middle(made)) return false;
            trial.points = {{request.domain.width / 2, request.domain.height / 2}};
            if (!is(kClasses, "none")) trial.classes = {0};
        } else {
            trial = trial_of(request);
        }
        if (trial.points.empty()) return false;
        // A count of fewer points than this trial has would need ellipses that are too long.
        if (request.count && has_ellipses() && request.domain.wraps())
            request.count = std::max<std::uint64_t>(*request.count, 2 * trial.points.size());
        if (!is(kKeep, "no")) choose_kept(made, trial);
        if (is(kLimit, "yes")) request.limit = 1 + choose_.below(most_points());
        if (is(kFrame, "yes") && !is_refused) {
            const double least = 1.5 * size_ * spread_of(made);
            const double more = request.domain.shorter_side() / 2 - least;
            made.frame = choose_.one_in(2) ? least : least + choose_.in(0, 0.99) * more;
        }
        if (is(kFrame, "yes") && is_refused) made.frame = request.domain.shorter_side() / 4;
        return true;
    }

    static bool is_open_in_the_middle(const Made& made) {
        const auto is_open = [](const auto& pixels, const auto& values) {
            return values[std::size_t{pixels.rows - 1 - pixels.rows / 2} * pixels.columns +
                          pixels.columns / 2] != 0;
        };
        return (made.request.places.mask == nullptr || is_open(made.mask, made.mask.allowed)) &&
               (made.request.field == nullptr || is_open(made.field, made.field.importance));
    }

    static bool has_spare_pixels(Request request) {
        request.run_on.backend = "cpu";
        *request.count *= 2;
        try {
            sample(request);
        } catch (const BadRequest& error) {
            if (error.option() != "count") throw;
            return false;
        }
        return true;
    }

    void choose_moves(Made& made) {
        if (is(kRelax, "on a picture")) made.sparse = sparse_field(choose_);
        if (!is(kRelax, "no")) made.moves.iterations = 1 + choose_.below(3);
        if (is(kGaussian, "no")) return;
        made.moves.gaussian = choose_.some(40);
        made.moves.gaussian_distance =
            std::array{0.0, 0.9, 1.0, choose_.in(0, 1)}[choose_.below(4)];
    }

    bool has_polygons() const {
        return is(kInside, "yes") || is(kOutside, "yes") || is(kAvoid, "yes") || is(kNear, "yes");
    }
    bool has_ellipses() const { return is(kRadii, "ellipses"); }

    // The reference builds the whole cdf in each round, and a progressive order has many levels.
    std::uint32_t most_points() const {
        if (is(kOrder, "progressive")) return 50;
        return is(kRounds, "of one") ? 80 : has_ellipses() || !is(kClasses, "none") ? 150 : 300;
    }

    // On a torus a radius of at most the shorter side leaves no fewer points than its aspect.
    void choose_domain(Request& request) {
        const bool is_torus = request.domain.wraps();
        const bool is_short = has_ellipses() || is(kFrame, "yes");
        const double most = !is_torus ? 1000 : is_short ? 9 : most_points() / 1.5;
        const double aspect = is(kDomain, "long") ? choose_.power(3.2, most) : choose_.power(1, 3);
        const double side = choose_.power(1e-6, 1e6);
        request.domain.width = choose_.one_in(2) ? side : side * aspect;
        request.domain.height = request.domain.width == side ? side * aspect : side;
    }

    void choose_radii(Made& made) {
        Request& request = made.request;
        const bool is_torus = request.domain.wraps();
        const bool is_cells = is(kMode, "cells");
        const double shorter = request.domain.shorter_side();
        const double points = choose_.power(0.3, most_points());
        double radius = std::sqrt(0.7 * request.domain.width * request.domain.height / points);
        if (is(kLines, "given"))
            request.paper2011.lines_per_radius = choose_.some(is(kMode, "lines") ? 1000
                                                              : is_cells         ? 12
                                                                                 : 60);
        if (!is(kRadii, "one")) {
            made.field = is(kFrame, "yes") ? random_field(choose_, 12, 4)
                         : has_ellipses()  ? random_field(choose_, 12, 50)
                                           : random_field(choose_, 60, is_cells ? 1e4 : 1e12);
            radius *= is_cells ? 1 : std::sqrt(mean_of(made.field));
            if (has_ellipses()) radius = choose_stretches(made.field, radius, is_torus, shorter);
            request.field = &made.field;
        } else {
            radius = std::min(
                radius,
                is_torus ? shorter : std::hypot(request.domain.width, request.domain.height));
        }
        if (!is(kClasses, "none")) {
            // docs/placement.md: distances may differ by 4,000; progressive orders of such take
            // long. Nearly equal ones must not become equal in whole numbers.
            const bool may_differ = !request.progressive && !is(kFrame, "yes");
            double ratio = is(kFrame, "yes") ? 2 : may_differ && choose_.one_in(6) ? 300 : 8;
            if (choose_.one_in(4)) ratio = 1 + choose_.power(1e-9, 0.03);
            choose_classes(choose_, made, ratio);
            radius *= std::sqrt(crowd_of(request.classes));
        }
        if (is(kFrame, "yes")) radius = std::min(radius, shorter / 3.2 / spread_of(made));
        if (!is(kClasses, "none"))
            made.scale_classes(is(kSize, "of classes") ? radius : choose_.power(1e-3, 1e3));
        size_ = radius;
        if (is(kSize, "given"))
            (request.field != nullptr ? request.scale : request.radius) = radius;
        if (is(kSize, "count"))
            request.count = static_cast<std::uint64_t>(
                std::ceil(has_ellipses() && is_torus ? 2 * points_of(made, radius) : points));
    }

    static double points_of(const Made& made, double scale) {
        return 0.7 * made.request.domain.width * made.request.domain.height * mean_of(made.field) /
               scale / scale;
    }

    // The greatest distance of two points over the radius or scale.
    static double spread_of(const Made& made) {
        const std::vector<double>& distances = made.request.classes.distances;
        double spread = distances.empty() ? 1
                                          : *std::max_element(distances.begin(), distances.end()) /
                                                made.least_distance();
        if (made.request.field == nullptr) return spread;
        double greatest = 0;
        for (std::size_t i = 0; i < made.field.importance.size(); ++i)
            if (made.field.importance[i] > 0)
                greatest = std::max(
                    greatest, (made.field.stretches.empty() ? 1 : made.field.stretches[i].ratio) /
                                  made.field.importance[i]);
        return spread * std::sqrt(greatest);
    }

    // The points of all classes, if each were alone, over those of one that keeps a distance of 1.
    static double crowd_of(const Classes& classes) {
        double crowd = 0;
        for (std::size_t i = 0; i < classes.names.size(); ++i)
            if (classes.weights.empty() || classes.weights[i] > 0)
                crowd += std::pow(classes.distances[i * (classes.names.size() + 1)], -2);
        return crowd;
    }

    // Returns the scale: on a torus no ellipse may be longer than the shorter side.
    double choose_stretches(Field& field, double scale, bool is_torus, double shorter) {
        stretch_field(choose_, choose_.one_in(2), field);
        if (!is_torus) return scale;
        scale = std::min(scale, shorter / 2.2);
        const double least = std::pow(2.01 * scale / shorter, 2);
        for (std::size_t i = 0; i < field.importance.size(); ++i) {
            double& importance = field.importance[i];
            if (importance == 0) continue;
            importance = std::max(importance, least);
            field.stretches[i].ratio = std::min(field.stretches[i].ratio, importance / least);
        }
        return scale;
    }

    // Masks of some classes. With points outside all have one size.
    void choose_masks(Made& made) {
        const Mask first = random_mask(choose_);
        for (std::size_t i = 0; i < made.request.classes.names.size(); ++i) {
            made.masks.push_back(choose_.one_in(3) ? first : random_mask(choose_));
            Mask& mask = made.masks.back();
            if (is(kKeep, "outside") && mask.allowed.size() != first.allowed.size()) mask = first;
            if (is(kKeep, "outside")) mask.columns = first.columns, mask.rows = first.rows;
            made.request.places.masks.push_back(i > 0 && choose_.one_in(3) ? nullptr : &mask);
        }
        if (!choose_.one_in(2)) return;
        made.mask = first;
        made.request.places.mask = &made.mask;
    }

    // On a torus obstacles have images on all sides.
    static void add_images(const Domain& domain, std::vector<PolygonRing>& rings) {
        const std::vector<PolygonRing> own = rings;
        for (const double across : {-domain.width, 0.0, domain.width})
            for (const double up : {-domain.height, 0.0, domain.height})
                for (PolygonRing ring : own) {
                    for (Point& point : ring) point = {point.x + across, point.y + up};
                    if (across != 0 || up != 0) rings.push_back(std::move(ring));
                }
    }

    // Returns false if the polygons leave nothing.
    bool choose_polygons(Made& made) {
        Request& request = made.request;
        const Domain& domain = request.domain;
        const double area = domain.width * domain.height;
        const double typical = std::sqrt(0.7 * area / most_points());
        made.edge = std::max(typical * std::pow(2, -choose_.in(1, 6)), std::sqrt(area) / 300);
        const auto add = [&](std::vector<PolygonRing> rings, PolygonSet set) {
            if (domain.wraps() && has_distance(set.role)) add_images(domain, rings);
            made.rings.push_back(std::move(rings));
            set.rings = made.rings.back();
            made.polygons.push_back(std::move(set));
        };
        const auto next = [&] {
            return RandomPolygons(choose_.random(), domain, made.edge).next();
        };
        const auto some = [&] { return typical * choose_.power(0.1, 2); };
        for (std::uint32_t more = 1 + choose_.below(2); more != 0; --more) {
            if (is(kInside, "yes")) add(next(), {.distance = choose_.one_in(2) ? 0 : some()});
            if (is(kOutside, "yes"))
                add(next(), {.role = Role::outside, .distance = choose_.one_in(2) ? 0 : some()});
            if (is(kAvoid, "yes"))
                add(random_lines(choose_, domain), {.role = Role::avoid, .distance = some()});
            if (is(kNear, "yes"))
                add(random_lines(choose_, domain), {.role = Role::near, .distance = 4 * some()});
        }
        made.mask = draw_mask(made.polygons, request.domain, made.edge);
        request.places.mask = &made.mask;
        return has_places(request);
    }

    // A set of mode exact with fewer points than the one that is asked for, or of the same size.
    Result trial_of(Request request) {
        request.run_on.backend = "cpu";
        request.mode = Mode::exact;
        request.on_pixels.reset();
        request.seed = choose_.random()();
        request.progressive = request.paper2011.snap = request.paper2011.uniform_x = false;
        request.metric = Metric::min;
        if (!request.count) return sample(request);
        request.count.reset();
        const bool is_torus = request.domain.wraps();
        const double size = has_ellipses() && is_torus ? size_ : 2 * size_;
        if (request.field != nullptr)
            request.scale = size;
        else
            request.radius =
                is_torus ? std::min(size, request.domain.shorter_side())
                         : std::min(size, std::hypot(request.domain.width, request.domain.height));
        return sample(request);
    }

    // Points that are there already: the first ones of another set, and for some disks points at
    // places that are hard.
    void choose_kept(Made& made, const Result& trial) {
        const std::uint64_t most = std::min<std::uint64_t>(
            trial.points.size(), (made.request.count.value_or(trial.points.size()) + 3) / 4);
        const auto many =
            1 + choose_.below(static_cast<std::uint32_t>(std::max<std::uint64_t>(most, 1)));
        made.keep.assign(trial.points.begin(), trial.points.begin() + many);
        if (!trial.classes.empty())
            made.keep_classes.assign(trial.classes.begin(), trial.classes.begin() + many);
        const bool is_plain =
            is(kMode, "exact") && is(kSize, "given") && is(kClasses, "none") && is(kKeep, "yes");
        if (is_plain && !has_ellipses() && choose_.one_in(2)) add_hard_points(choose_, made);
        if (is(kKeep, "outside")) choose_neighbours(made);
        const Request& request = made.request;
        made.keep_all();
        // At the size that a count leads to, kept points may be too close together.
        while (is(kMode, "exact") && request.count && request.keep.size() > 1 &&
               !is_fair(request, made.seeds)) {
            made.keep.resize(made.keep.size() / 2);
            if (!made.keep_classes.empty()) made.keep_classes.resize(made.keep.size());
            made.neighbours.resize((made.neighbours.size() + 1) / 2);
            if (!made.neighbour_classes.empty())
                made.neighbour_classes.resize(made.neighbours.size());
            made.keep_all();
        }
    }

    // Points outside of the domain, most of them within the greatest distance: beside its sides and
    // corners, as near as can be or just out of reach. Each keeps its distance from all others.
    void choose_neighbours(Made& made) {
        const Request& request = made.request;
        const Classes& classes = request.classes;
        const std::size_t kinds = std::max<std::size_t>(1, classes.names.size());
        double least = std::numeric_limits<double>::infinity(), greatest = 0;
        for (const double one : classes.distances) {
            if (one > 0) least = std::min(least, one);
            greatest = std::max(greatest, one);
        }
        const double size = request.count           ? 2 * size_
                            : request.radius        ? *request.radius
                            : classes.names.empty() ? size_
                                                    : least;
        const auto apart = [&](std::size_t a, std::size_t b) {
            return classes.names.empty() ? size : size / least * classes.distances[a * kinds + b];
        };
        const double reach = classes.names.empty() ? size : size / least * greatest;
        const auto beside = [&](double side) {
            const double far =
                reach * std::array{1e-9, choose_.in(0, 1), 1 - 1e-9, 1.001, 3.0}[choose_.below(5)];
            return choose_.one_in(2) ? -far : side + far;
        };
        for (int tries = 60; tries != 0 || made.neighbours.empty(); --tries) {
            const double width = request.domain.width, height = request.domain.height;
            const std::uint32_t where = choose_.below(5);
            const Point at{where < 2 ? choose_.in(0, width) : beside(width),
                           where == 2 || where == 3 ? choose_.in(0, height) : beside(height)};
            const auto kind =
                static_cast<std::uint8_t>(choose_.below(static_cast<std::uint32_t>(kinds)));
            if (request.domain.holds(at)) continue;
            made.keep_all();
            const auto is_far = [&](std::size_t other) {
                const std::size_t of_other =
                    classes.names.empty() ? 0 : made.all_kept_classes[other];
                return judge::distance(made.request.domain, at, made.all_kept[other]) >=
                       apart(kind, of_other);
            };
            bool fits = true;
            for (std::size_t i = 0; i < made.all_kept.size(); ++i) fits = fits && is_far(i);
            if (!fits && tries > -60) continue;
            made.neighbours.push_back(fits ? at : Point{-9 * reach - width, 0});
            if (!classes.names.empty()) made.neighbour_classes.push_back(kind);
        }
    }

    static bool is_fair(Request request, const std::vector<std::uint64_t>& seeds) {
        request.run_on.backend = "cpu";
        try {
            for (const std::uint64_t seed : seeds) {
                request.seed = seed;
                sample(request);
            }
        } catch (const BadRequest& error) {
            return error.option() != "keep";
        }
        return true;
    }

    Chooser choose_;
    const Row row_;
    double size_ = 0;  // the radius or scale; of a count, one that leaves no more points
};

}  // namespace lacuna::tests
