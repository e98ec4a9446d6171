// Ellipses, seen from outside: sets with stretched fields by a judge of this file's own, in double
// and from the points alone; what is kept, limited and counted; refusals in one line.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "fields.h"
#include "refusal.h"

namespace ellipses_test {

using namespace lacuna;

using Random = std::mt19937_64;

double between(Random& random, double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
}

class Judge {
public:
    Judge(const Request& request, double scale) : request_(request) {
        const Field& field = *request.field;
        for (std::size_t i = 0; i < field.importance.size(); ++i) {
            const auto& [ratio, angle] = field.stretches[i];
            const double radius = scale / std::sqrt(field.importance[i]);
            const double longer = radius * std::sqrt(ratio), shorter = radius / std::sqrt(ratio);
            ellipses_.push_back({{std::cos(angle) / longer, std::sin(angle) / longer},
                                 {-std::sin(angle) / shorter, std::cos(angle) / shorter}});
        }
    }

    std::size_t pixel_of(Point at) const {
        const Field& field = *request_.field;
        const auto along = [](double share, std::uint32_t pixels) {
            return std::min(static_cast<std::uint32_t>(share * pixels), pixels - 1);
        };
        const std::size_t row = field.rows - 1 - along(at.y / request_.domain.height, field.rows);
        return row * field.columns + along(at.x / request_.domain.width, field.columns);
    }
    bool is_allowed(Point at) const { return request_.field->importance[pixel_of(at)] > 0; }

    // The way from one point to another, as a multiple of the radius that each one's ellipse has in
    // that direction: the greater of both. Below 1 they are in conflict.
    double apart(Point a, Point b) const {
        double dx = b.x - a.x, dy = b.y - a.y;
        if (request_.domain.wraps()) {
            dx -= request_.domain.width * std::round(dx / request_.domain.width);
            dy -= request_.domain.height * std::round(dy / request_.domain.height);
        }
        return std::max(length_in(pixel_of(a), dx, dy), length_in(pixel_of(b), dx, dy));
    }

private:
    double length_in(std::size_t pixel, double dx, double dy) const {
        const auto& [along, across] = ellipses_[pixel];
        const double u = dx * along.x + dy * along.y, v = dx * across.x + dy * across.y;
        return std::sqrt(u * u + v * v);
    }

    struct Axes {
        Point along;  // over the longer radius
        Point across;
    };
    const Request& request_;
    std::vector<Axes> ellipses_;
};

// The least distance of any two points in their ellipses, over all pairs.
double least_apart(const Judge& judge, const std::vector<Point>& points) {
    double least = 2;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, judge.apart(points[i], points[j]));
    return least;
}

// How far the spot is from the nearest point.
double room_at(const Judge& judge, const std::vector<Point>& points, Point spot) {
    double room = 2;
    for (const Point point : points) room = std::min(room, judge.apart(spot, point));
    return room;
}

struct Made {
    Field field;
    Request request;
};

// Angles at random or a swirl, in one pixel to many; on a torus no ellipse is too long.
void make_hostile(Random& random, Made& made) {
    const bool is_one = random() % 4 == 0;
    const auto pixels = [&] { return is_one ? 1 : static_cast<std::uint32_t>(1 + random() % 9); };
    const std::uint32_t columns = pixels(), rows = pixels();
    Field plain = tests::made_field(columns, rows, [&](double, double) {
        return random() % 10 == 0 && !is_one ? 0.0 : std::exp(between(random, 0, 3));
    });
    plain.importance.front() = 1;
    const double ratio = std::exp(between(random, 0, std::log(32)));
    made.field = random() % 2 == 0 ? tests::swirled(plain, ratio)
                                   : tests::stretched_at_random(plain, ratio, random());
    Request& request = made.request;
    request.field = &made.field;
    request.domain.width = between(random, 0.3, 2);
    request.domain.boundary = random() % 2 == 0 ? Boundary::torus : Boundary::box;
    const double shorter = request.domain.shorter_side();
    request.scale = tests::scale_of(made.field, request.domain.width * request.domain.height,
                                    std::exp(between(random, 0, 5.5)));
    if (!request.domain.wraps() && random() % 6 == 0) request.scale = 3 * shorter;
    double longest = 0;
    for (std::size_t i = 0; i < made.field.importance.size(); ++i)
        if (made.field.importance[i] > 0)
            longest = std::max(longest, *request.scale * std::sqrt(made.field.stretches[i].ratio /
                                                                   made.field.importance[i]));
    if (request.domain.wraps())
        request.scale = *request.scale * std::min(1.0, 0.49 * shorter / longest);
    request.seed = random();
    request.paper2011.round_size = random() % 3 == 0 ? 1 + random() % 100 : 0;
    request.place.backend = "cpu";
}

TEST(EllipsesOfHostileFields, KeepTheirDistancesAndLeaveNoRoom) {
    Random random(44);
    std::uint64_t points = 0, probes = 0, refuted = 0;
    std::uint64_t sets = 0;
    for (int i = 0; i < 1500; ++i) {
        Made made;
        make_hostile(random, made);
        Result result = sample(made.request);
        if (result.points.size() > 400) continue;
        ++sets;
        const Judge judge(made.request, result.scale);
        ASSERT_TRUE(result.maximal);
        ASSERT_GE(least_apart(judge, result.points), 1) << "case " << i;
        for (const Point point : result.points) ASSERT_TRUE(judge.is_allowed(point)) << i;
        const Point last = result.points.back();
        for (int k = 0; k < 200; ++k) {
            const Point spot{between(random, 0, made.request.domain.width),
                             between(random, 0, made.request.domain.height)};
            if (!judge.is_allowed(spot)) continue;
            ++probes;
            ASSERT_LT(room_at(judge, result.points, spot), 1 + 1e-5) << "case " << i;
        }
        points += result.points.size();
        // Without its last point the place of that point is free.
        result.points.pop_back();
        refuted += room_at(judge, result.points, last) >= 1 ? 1U : 0U;
    }
    EXPECT_GT(sets, 1000U);
    EXPECT_GT(points, 50'000U);
    EXPECT_GT(probes, 100'000U);
    EXPECT_GT(refuted, sets * 99 / 100);
}

Field swirl() {
    return tests::swirled(tests::constant_field(12, 12), 5);
}

Request request_of(const Field& field) {
    Request request;
    request.field = &field;
    request.scale = 0.02;
    request.place.backend = "cpu";
    return request;
}

TEST(EllipsesAroundKeptPoints, KeepTheirDistancesFromThem) {
    const Field field = swirl();
    Request request = request_of(field);
    const std::vector<Point> whole = sample(request).points;
    const std::vector<Point> kept(whole.begin(), whole.begin() + 100);
    request.keep = kept;
    request.seed = 5;
    const Result result = sample(request);
    const Judge judge(request, result.scale);
    EXPECT_GE(least_apart(judge, result.points), 1);
    EXPECT_TRUE(std::equal(kept.begin(), kept.end(), result.points.begin()));
    // Neighbours across the short radius, which disks of the same area would not allow.
    request.keep = whole;
    EXPECT_EQ(sample(request).points.size(), whole.size());
}

TEST(Ellipses, AreCountedAndLimitedAsDisksAre) {
    const Field field = swirl();
    Request request = request_of(field);
    const std::vector<Point> whole = sample(request).points;
    request.limit = 321;
    EXPECT_EQ(sample(request).points, std::vector<Point>(whole.begin(), whole.begin() + 321));
    request.limit.reset();
    request.scale.reset();
    request.count = 1000;
    const Result counted = sample(request);
    EXPECT_EQ(counted.points.size(), 1000U);
    EXPECT_GE(least_apart(Judge(request, counted.scale), counted.points), 1);
}

TEST(Ellipses, ComeInProgressiveOrder) {
    const Field field = swirl();
    Request request = request_of(field);
    request.progressive = true;
    const Result result = sample(request);
    ASSERT_GT(result.levels.size(), 3U);
    for (const Level& level : result.levels) {
        const std::vector<Point> prefix(
            result.points.begin(),
            result.points.begin() + static_cast<std::ptrdiff_t>(level.points));
        ASSERT_GE(least_apart(Judge(request, level.size), prefix), 1) << level.points;
    }
}

// At the radius of 16 points the ellipses would be longer than the torus.
TEST(Ellipses, BeginTheirOrderAtALevelWhereTheyFitOnATorus) {
    const Field field = tests::swirled(tests::constant_field(12, 12), 25);
    Request request = request_of(field);
    request.domain.boundary = Boundary::torus;
    request.scale = 0.09;
    request.progressive = true;
    const Result result = sample(request);
    EXPECT_TRUE(result.maximal);
    EXPECT_LE(result.levels.front().size, 0.1);
    EXPECT_GE(least_apart(Judge(request, result.scale), result.points), 1);
}

TEST(Ellipses, AreRefusedByNumberAndPlace) {
    Field field = swirl();
    Request request = request_of(field);
    const auto refused = [&] { return tests::refusal_of([&] { sample(request); }); };
    field.stretches[14] = {0.5, 0};
    EXPECT_EQ(refused(),
              "stretches 0.5 at an angle of 0 at row 1, column 2: ratios must lie between 1 and "
              "1000, angles between -1000 and 1000");
    field.stretches[14] = {2, std::nan("")};
    EXPECT_EQ(refused(),
              "stretches 2 at an angle of nan at row 1, column 2: ratios must lie between 1 and "
              "1000, angles between -1000 and 1000");
    field.stretches[14] = {2, 1};
    request.mode = Mode::cells;
    EXPECT_EQ(refused(), "stretches with mode cells: are for mode exact");
    request.mode = Mode::exact;
    request.domain.boundary = Boundary::torus;
    request.scale = 0.3;
    EXPECT_EQ(refused(),
              "torus with an ellipse of length 1.34164: must be at most the domain's shorter side, "
              "1");
    request.domain.boundary = Boundary::box;
    field.stretches.pop_back();
    EXPECT_EQ(refused(),
              "stretches 143 values: there must be one for each pixel of the field, 144");
    field = swirl();
    const std::vector<Point> kept{{0.5, 0.9}, {0.5, 0.93}};
    request.keep = kept;
    EXPECT_NE(refused().find("are 0.03"), std::string::npos) << refused();
}

}  // namespace ellipses_test
