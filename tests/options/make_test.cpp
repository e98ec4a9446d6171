// options::make: a set is sampled, then relaxed, or what relaxing excludes is refused.
#include "options/make.h"

#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "judge/plane.h"
#include "options/settle.h"
#include "refusal.h"

namespace lacuna::options {
namespace {

using tests::refusal_of;

Made make(const Request& request, const Moves& moves) {
    Observer nobody;
    return options::make(request, moves, nobody);
}

Request counted(std::uint64_t count) {
    Request request;
    request.count = count;
    request.domain.boundary = Boundary::torus;
    return request;
}

TEST(Making, WithoutMovesIsSampling) {
    Request request;
    request.radius = 0.05;
    const Made made = make(request, {});
    EXPECT_EQ(made.result.points, sample(request).points);
    EXPECT_EQ(made.result.radius, 0.05);
    EXPECT_TRUE(made.result.maximal);
    EXPECT_FALSE(made.relaxed);
}

TEST(Making, WithMovesIsSamplingAndRelaxing) {
    for (const Mode mode : {Mode::exact, Mode::stratified}) {
        Request request = counted(200);
        request.mode = mode;
        const Made made = make(
            request, {.iterations = 3, .gaussian = 2, .gaussian_distance = 0.5, .measure = true});
        RelaxOptions options{.domain = {1, 1, Boundary::torus}, .iterations = 3, .gaussian = 2};
        options.gaussian_distance = 0.5;
        const std::vector<Point>& points = made.result.points;
        EXPECT_EQ(points, relax(sample(request).points, nullptr, options).points);
        EXPECT_FALSE(made.result.maximal);
        EXPECT_EQ(made.result.backend, "cpu");
        ASSERT_TRUE(made.relaxed);
        EXPECT_TRUE(made.relaxed->evenness);
        EXPECT_EQ(made.result.radius, judge::closest_pair(options.domain, points).distance);
    }
}

TEST(Making, OfOnePointHasNoLeastDistance) {
    EXPECT_EQ(make(counted(1), {.iterations = 1}).result.radius, 0);
    const std::vector<Point> pair{{0.1, 0.5}, {0.9, 0.5}};
    EXPECT_TRUE(std::isinf(least_distance(std::span(pair).first(1))));
    EXPECT_DOUBLE_EQ(least_distance(pair), 0.8);
    EXPECT_DOUBLE_EQ(least_distance(pair, {1, 1, Boundary::torus}), 0.2);
    EXPECT_EQ(refusal_of([&] {
                  least_distance(pair, {0.5, 1});
              }),
              "points 1: is the number of a point outside of the domain");
    EXPECT_EQ(refusal_of([&] { least_distance(pair, {0, 1}); }).substr(0, 6), "domain");
}

TEST(Making, CanBeCancelledWhileItRelaxes) {
    struct Impatient : Observer {
        bool keep_going(const Progress& progress) override {
            return progress.stage == Stage::sampling;
        }
    };
    Impatient observer;
    EXPECT_THROW(options::make(counted(100), {.iterations = 3}, observer), Cancelled);
}

TEST(Making, RefusesWhatRelaxingExcludes) {
    const Mask mask{1, 1, {1}};
    const Field ellipses{1, 1, {1}, {{4, 0.5}}};
    const std::vector<Point> kept{{0.5, 0.5}};
    const auto refused = [](const Request& request, const Moves& moves) {
        const std::string told = refusal_of([&] { make(request, moves); });
        return told.substr(0, told.find(':'));
    };
    const std::vector<std::pair<std::string, Request>> cases{
        {"--progressive", {.count = 20, .progressive = true}},
        {"--mask", {.count = 20, .places = {.mask = &mask}}},
        {"--border", {.count = 20, .places = {.border = 0.1}}},
        {"--keep", {.count = 20, .keep = kept}},
        {"--class", {.count = 20, .classes = {{"a"}, {0.1}}}},
        {"--ellipses", {.count = 20, .field = &ellipses}}};
    for (const auto& [excluded, request] : cases) {
        EXPECT_EQ(refused(request, {.iterations = 2}), "relax 2 with " + excluded);
        EXPECT_EQ(refused(request, {.gaussian = 2}), "gaussian 2 with " + excluded);
    }
    EXPECT_EQ(refused(counted(20), {.iterations = 10001}), "iterations 10001");
    EXPECT_EQ(refused(counted(20), {.gaussian_distance = 0.5}),
              "gaussian-distance 0.5 without --gaussian");
}

TEST(Settling, RefusesAMetricWithoutAField) {
    Request request;
    EXPECT_EQ(refusal_of([&] { settle({.metric = Metric::min}, request); }),
              "metric min: is for a field");
    EXPECT_EQ(refusal_of([&] { settle({.is_picture = true, .metric = Metric::min}, request); }),
              "accepted");
}

}  // namespace
}  // namespace lacuna::options
