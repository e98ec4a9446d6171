// Mean counts against the paper's Tables 1 and 2 (m = 30), 20 seeds each.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace {

using namespace lacuna;

struct Row {
    double radius;
    Boundary boundary;
    bool uniform_x;
    double paper;
};

// Table 1 (box) and Table 2 (torus): "Ours" and "Uniform-x".
constexpr Row kRows[] = {
    {0.05, Boundary::torus, false, 277.9},  {0.05, Boundary::torus, true, 280.7},
    {0.05, Boundary::box, false, 296.2},    {0.05, Boundary::box, true, 298.6},
    {0.01, Boundary::torus, false, 6938.1}, {0.01, Boundary::torus, true, 6965.7},
    {0.01, Boundary::box, false, 7030.3},   {0.01, Boundary::box, true, 7058.3},
    {0.005, Boundary::torus, false, 27762}, {0.005, Boundary::torus, true, 27825},
    {0.005, Boundary::box, false, 27952},   {0.005, Boundary::box, true, 28019},
};

void PrintTo(const Row& row, std::ostream* out) {
    *out << "radius " << row.radius;
}

class Counts : public testing::TestWithParam<Row> {
protected:
    static double mean(bool snap) {
        const Row row = GetParam();
        Request request;
        request.mode = Mode::lines;
        request.radius = row.radius;
        request.domain.boundary = row.boundary;
        request.paper2011.uniform_x = row.uniform_x;
        request.paper2011.snap = snap;
        request.paper2011.round_size = 1;
        request.run_on.backend = "reference";
        // Counts of large sets vary less: the mean of 8 is six times more precise than is asked.
        const std::uint64_t seeds = row.radius < 0.01 ? 8 : 20;
        std::size_t total = 0;
        for (request.seed = 0; request.seed < seeds; ++request.seed)
            total += sample(request).points.size();
        return static_cast<double>(total) / static_cast<double>(seeds);
    }
};

TEST_P(Counts, AreThePapersOnTheLinesAndInterpolated) {
    const Row row = GetParam();
    const bool few = row.radius == 0.05;
    const double snapped = mean(true);
    const double interpolated = mean(false);
    std::printf("| %g | %s | %s | %.1f | %.1f | %+.2f %% | %.1f | %+.2f %% |\n", row.radius,
                row.boundary == Boundary::torus ? "torus" : "box",
                row.uniform_x ? "uniform-x" : "cdf", row.paper, snapped,
                100 * (snapped / row.paper - 1), interpolated,
                100 * (interpolated / row.paper - 1));
    EXPECT_NEAR(snapped / row.paper, 1, few ? 0.01 : 0.003);
    EXPECT_NEAR(interpolated / row.paper, 1, few ? 0.015 : 0.005);
}

INSTANTIATE_TEST_SUITE_P(Paper, Counts, testing::ValuesIn(kRows), [](const auto& test) {
    const Row& row = test.param;
    return std::string(row.boundary == Boundary::torus ? "Torus" : "Box") +
           (row.uniform_x ? "UniformX" : "Cdf") +
           std::to_string(static_cast<int>(std::round(1 / row.radius)));
});

}  // namespace
