// All capabilities of sample_surface() and sample_volume(), random requests with the levels of a
// row, and what is demanded of their sets.
#pragma once

#include <lacuna/space.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "hostile/counts.h"
#include "hostile/pairs.h"
#include "space/meshes.h"

namespace lacuna::tests {

enum InSpace : std::size_t { kShape, kGiven, kKept, kCutOff, kAllowed, kDrawn, kShared, kPlace };

inline const Tables kSpace{
    {
        {"shape", {"soup", "sphere", "ribbon", "one spot", "box", "torus"}},
        {"given", {"a radius", "a count", "a radius for few"}},
        {"keep", {"no", "its own", "others'"}},
        {"limit", {"no", "yes"}},
        {"allowed", {"all", "some"}},
        {"rounds", {"automatic", "of one", "small", "large"}},
        {"threads", {"one", "several"}},
        {"place", {"near 0", "far from 0", "tiny"}},
    },
    {
        {kShape, "box", kAllowed, "some", {"allowed"}},
        {kShape, "torus", kAllowed, "some", {"allowed"}},
        {kShape, "one spot", kGiven, "a count", {"count"}},
        {kShape, "box", kPlace, "far from 0", {}},  // volumes begin at 0
        {kShape, "torus", kPlace, "far from 0", {}},
        {kShape, "one spot", kPlace, "!near 0", {}},  // it has no extent to compare with
        {kGiven, "a count", kKept, "!no", {}},        // kept points may be closer than its radius
    },
};

// A request that owns what it refers to.
struct MadeInSpace {
    SpaceRequest request{};
    Mesh mesh{};
    std::vector<std::uint8_t> allowed{};
    std::vector<Point3> keep{};
    double size = 1;  // the longest side of the volume or of the box around the mesh, about
};

inline SpaceResult made_in_space(const SpaceRequest& request) {
    return request.mesh != nullptr ? sample_surface(request) : sample_volume(request);
}

class RandomInSpace {
public:
    RandomInSpace(std::uint64_t seed, std::uint64_t number, const Row& row)
        : row_(row), random_(seed + 1000003 * number) {}

    void make(MadeInSpace& made) {
        SpaceRequest& request = made.request;
        request.seed = random_();
        if (is(kShape, "box") || is(kShape, "torus")) {
            request.volume = {1, between(0.5, 1), between(0.5, 1),
                              is(kShape, "torus") ? Boundary::torus : Boundary::box};
        } else {
            made.mesh = mesh();
            request.mesh = &made.mesh;
        }
        place(made);
        const double few = request.mesh == nullptr ? 0.45 : 0.7;
        // The reference compares all samples with all bins in each round.
        const bool has_many_rounds = is(kDrawn, "of one") || is(kDrawn, "small");
        const double many = has_many_rounds           ? 0.5 * few
                            : request.mesh == nullptr ? between(0.15, 0.25)
                                                      : between(0.06, 0.15);
        const double radius = made.size * (is(kGiven, "a radius for few") ? few : many);
        request.radius = radius;
        if (!is(kAllowed, "all")) {
            const std::size_t count = request.mesh == nullptr ? 1 : made.mesh.triangles.size();
            for (std::size_t i = 0; i < count; ++i)
                made.allowed.push_back(i == 0 || random_() % 2 == 0 ? 1 : 0);
            request.allowed = made.allowed;
        }
        if (!is(kKept, "no")) keep(made);
        if (is(kGiven, "a count")) {
            request.radius.reset();
            request.count = 1 + random_() % 60;
        }
        if (is(kCutOff, "yes")) request.limit = 1 + random_() % 20;
        if (is(kDrawn, "of one")) request.round_size = 1;
        if (is(kDrawn, "small")) request.round_size = 2 + random_() % 8;
        if (is(kDrawn, "large")) request.round_size = 40000;
        request.run_on.threads = is(kShared, "several") ? 2 + random_() % 2 : 1;
    }

private:
    bool is(std::size_t capability, std::string_view level) const {
        return is_level(kSpace, row_, capability, level);
    }
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() >> 11U) * 0x1p-53;
    }
    Mesh mesh() {
        const auto seed = static_cast<std::uint32_t>(random_());
        if (is(kShape, "sphere")) return sphere(3 + seed % 12);
        if (is(kShape, "one spot")) return {{{0, 0, 0}}, {{0, 0, 0}}};
        if (is(kShape, "ribbon")) {
            const double wide = std::pow(10.0, -between(0, 6));
            return {{{0, 0, 0}, {1, 0.1, 0.2}, {1, 0.1 + wide, 0.2}, {0, wide, 0}},
                    {{0, 1, 2}, {0, 2, 3}, {3, 2, 0}}};
        }
        return soup(1 + seed % 40, seed);
    }
    void place(MadeInSpace& made) {
        if (is(kShape, "sphere")) made.size = 2;
        if (is(kPlace, "near 0")) return;
        const double scale = is(kPlace, "tiny") ? 1e-9 : 1;
        const double shift = is(kPlace, "far from 0") ? -20 : 0;
        made.size *= scale;
        for (Point3& at : made.mesh.vertices)
            at = {shift + at.x * scale, shift + at.y * scale, at.z * scale};
        Volume& volume = made.request.volume;
        volume = {volume.width * scale, volume.height * scale, volume.depth * scale,
                  volume.boundary};
    }
    // Half of a set of a somewhat larger radius.
    void keep(MadeInSpace& made) {
        SpaceRequest larger = made.request;
        larger.radius = *larger.radius * 1.01;
        if (made.request.mesh == nullptr) larger.allowed = {};
        made.keep = made_in_space(larger).points;
        made.keep.resize((made.keep.size() + 1) / 2);
        // Others' points lie between the units.
        if (is(kKept, "others'"))
            for (Point3& point : made.keep)
                if (made.request.mesh != nullptr || point.x > 1e-9 * made.size)
                    point.x -= 1e-10 * made.size * between(0, 8);
        made.request.keep = made.keep;
        ++made.request.seed;
    }

    const Row& row_;
    std::mt19937_64 random_;
};

struct AnswerInSpace {
    SpaceResult set{};
    std::string refusal{};
};

inline AnswerInSpace answer_in_space(SpaceRequest request, const std::string& backend,
                                     std::uint32_t threads) {
    request.run_on = {.backend = backend, .threads = threads};
    try {
        return {made_in_space(request), ""};
    } catch (const BadRequest& error) {
        return {{}, error.what()};
    }
}

// The reference's answer, after all others have been found to be the same.
inline AnswerInSpace answer_of_all(const SpaceRequest& request,
                                   const std::vector<std::string>& names, Counts& counts) {
    AnswerInSpace expected = answer_in_space(request, names.front(), 1);
    for (std::size_t i = 1; i < names.size(); ++i) {
        const AnswerInSpace got = answer_in_space(request, names[i], request.run_on.threads);
        const SpaceResult &a = got.set, &b = expected.set;
        demand(got.refusal == expected.refusal && a.points == b.points &&
                   a.triangles == b.triangles && a.shares == b.shares && a.rounds == b.rounds &&
                   a.draws == b.draws && a.maximal == b.maximal && a.radius == b.radius,
               names[i] + " answers: " + std::to_string(a.points.size()) + " points, " +
                   got.refusal + "\n  " + names.front() + ": " + std::to_string(b.points.size()) +
                   " points, " + expected.refusal);
        ++counts.comparisons;
    }
    return expected;
}

// The least distance of two points, from all pairs.
inline double least_of_pairs(const std::vector<Point3>& points, const Volume* torus) {
    const auto across = [&](double way, double side) {
        return torus == nullptr ? way : std::abs(way) - side * std::round(std::abs(way) / side);
    };
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const Point3 &a = points[i], &b = points[k];
            const Volume sides = torus == nullptr ? Volume{} : *torus;
            least = std::min(
                least, std::hypot(across(a.x - b.x, sides.width), across(a.y - b.y, sides.height),
                                  across(a.z - b.z, sides.depth)));
        }
    return least;
}

// The set keeps what it promises, and is refuted with one point less or too close.
inline void judge_in_space(const MadeInSpace& made, const SpaceResult& set, std::mt19937_64& random,
                           Counts& counts) {
    const SpaceRequest& request = made.request;
    const bool is_torus = request.mesh == nullptr && request.volume.boundary == Boundary::torus;
    const bool is_whole = !request.count && !request.limit;
    demand(!is_whole || set.maximal, "the set is not maximal");
    demand(!request.count || request.limit || set.points.size() == *request.count, "not its count");
    demand(!request.limit || set.points.size() <= std::max<std::size_t>(*request.limit, 1),
           "more points than the limit");
    const std::size_t kept = std::min(made.keep.size(), set.points.size());
    demand(std::equal(made.keep.begin(), made.keep.begin() + static_cast<long>(kept),
                      set.points.begin()),
           "kept points do not come first");
    const double least = least_of_pairs(set.points, is_torus ? &request.volume : nullptr);
    demand(least >= set.radius * (made.keep.empty() ? 1 : 1 - 1e-8), "two points are too close");

    // The claim is of the triangles that are allowed.
    Mesh allowed = made.mesh;
    for (std::size_t i = allowed.triangles.size(); i-- > 0 && !made.allowed.empty();)
        if (made.allowed[i] == 0)
            allowed.triangles.erase(allowed.triangles.begin() + static_cast<long>(i));
    SpaceClaim claim{.mesh = request.mesh == nullptr ? nullptr : &allowed,
                     .volume = request.volume,
                     .radius = set.radius * (made.keep.empty() ? 1 : 1 - 1e-8)};
    if (!made.keep.empty()) claim.tolerance = made.size * 0x1p-25;
    const SpaceProof proof = prove(set.points, claim);
    ++counts.proofs;
    demand(!proof.outside, "a point lies outside");
    demand(proof.kept, "the proof finds two points that are too close");
    demand(proof.covered || !set.maximal, "the proof finds a gap of " +
                                              std::to_string(proof.largest_gap_distance) +
                                              ", the radius is " + std::to_string(set.radius));
    ++counts.sets;
    counts.points += set.points.size();
    if (set.points.size() < 2 || !set.maximal) return;

    std::vector<Point3> less = set.points;
    less.erase(less.begin() + static_cast<long>(random() % less.size()));
    ++(prove(less, claim).covered ? counts.as_good : counts.refuted);
    std::vector<Point3> close = set.points;
    close.back() = close.front();
    demand(!prove(close, claim).kept, "the proof accepts two points at one spot");
    ++counts.refuted;
}

}  // namespace lacuna::tests
