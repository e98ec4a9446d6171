// A count is met exactly; and the error of the scale by the formula of docs/design.md, section 5,
// alone.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "fields.h"
#include "judge/cells.h"
#include "plan/make_plan.h"
#include "plan/sizes.h"

namespace {

using namespace lacuna;

std::vector<std::pair<std::string, Field>> fields() {
    std::vector<std::pair<std::string, Field>> all = {
        {"constant", tests::constant_field(8, 6)},
        {"ramp", tests::ramp_field(256, 192)},
        {"step 10:1", tests::step_field(64, 48)},
        {"white holes", tests::white_holes_field(256, 192)},
        {"one dark pixel", tests::one_dark_pixel_field(16, 12)},
        {"1 x 200", tests::ramp_field(1, 200)},
        {"noise 64 x 48", tests::noise_field(64, 48, 1)},
        {"noise 512 x 384", tests::noise_field(512, 384, 1)},
    };
#ifdef LACUNA_RACCOON
    all.emplace_back("raccoon 256 x 192", tests::raccoon_field(256));
    all.emplace_back("raccoon 1024 x 768", tests::raccoon_field(1024));
#endif
    return all;
}

Request count_request(const Field& field, std::uint64_t count) {
    Request request;
    request.mode = Mode::cells;
    request.field = &field;
    request.domain.width = 4;
    request.domain.height = 3;
    request.count = count;
    return request;
}

TEST(CellsCounts, AreMetExactlyOnEveryField) {
    for (const auto& [name, field] : fields()) {
        for (const std::uint64_t count : {1u, 2u, 17u, 1000u, 20'000u}) {
            for (const Metric metric : {Metric::min, Metric::mean, Metric::max}) {
                if (metric != Metric::min && count > 17) continue;
                SCOPED_TRACE(name + ", " + std::to_string(count));
                Request request = count_request(field, count);
                request.metric = metric;
                const Result result = sample(request);
                EXPECT_EQ(result.points.size(), count);
                EXPECT_EQ(result.lines_per_radius, 10u);
                request.scale = result.scale;
                request.count.reset();
                request.paper2011.lines_per_radius = 10;
                EXPECT_EQ(judge::CellsJudge(request, result.points).fault(), "");
            }
        }
    }
}

// One dark column of a thousand, which coarse lattices miss.
TEST(CellsCounts, AreMetWherePixelsAreFinerThanTheLattice) {
    Field field = tests::constant_field(1000, 3, 0);
    for (std::size_t row = 0; row < 3; ++row) field.importance[row * 1000 + 617] = 1;
    for (const Metric metric : {Metric::min, Metric::mean, Metric::max}) {
        for (const std::uint64_t count : {1u, 2u, 3u, 17u, 100u}) {
            Request request = count_request(field, count);
            request.metric = metric;
            const std::vector<Point> points = sample(request).points;
            EXPECT_EQ(points.size(), count);
            for (const Point point : points) {
                EXPECT_GE(point.x, 617 / 250.0);
                EXPECT_LE(point.x, 618 / 250.0);
            }
        }
    }
}

// With max the first sample covers the light half, and the dark half beside it as far as its wide
// radius. A slightly smaller scale gives thousands of points instead of one.
TEST(CellsCounts, AreMetWhereOneSampleMayCoverAll) {
    const Field field =
        tests::made_field(64, 64, [](double x, double) { return x < 0.5 ? 1 : 1e-5; });
    for (const std::uint64_t count : {5u, 100u, 3000u, 10'000u}) {
        Request request = count_request(field, count);
        request.metric = Metric::max;
        EXPECT_EQ(sample(request).points.size(), count);
    }
}

// The fraction of the count that a maximal set at that scale holds.

double over_at(double scale, const Field& field, std::uint64_t count) {
    Request request = count_request(field, count);
    request.scale = scale;
    request.count.reset();
    return static_cast<double>(sample(request).points.size()) / static_cast<double>(count);
}

// A maximal set at the chosen scale has few points too many: dropping some thins it little.
TEST(CellsCounts, AreNearTheMaximalSetsAtTheScaleChosen) {
    std::printf("| field | N | formula of design.md | less the lattice's loss | as chosen |\n");
    for (const auto& [name, field] : fields()) {
        for (const std::uint64_t count : {1000u, 20'000u}) {
            const Request request = count_request(field, count);
            const double by_area = tests::scale_of(field, 12, static_cast<double>(count));
            const double formula = over_at(by_area, field, count);
            const double less_loss =
                over_at(scale_for_count(request, sums_of(field), count), field, count);
            const double chosen = over_at(sample(request).scale, field, count);
            std::printf("| %s | %u | %+.1f %% | %+.1f %% | %+.1f %% |\n", name.c_str(),
                        static_cast<unsigned>(count), 100 * (formula - 1), 100 * (less_loss - 1),
                        100 * (chosen - 1));
            EXPECT_GE(chosen, 1) << name;
            EXPECT_LE(chosen, count == 1000 ? 1.15 : 1.08) << name;
        }
    }
}

}  // namespace
