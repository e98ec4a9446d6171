// The kernels of mode cells do the work, and nothing else does.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "backends/available.h"
#include "backends/cells_scenes.h"
#include "backends/opencl/make_backend.h"
#include "backends/opencl/trials.h"

namespace lacuna::opencl {
namespace {

std::string altered(const std::string& from, const std::string& to) {
    return opencl::altered(cells_kernel_source(), from, to);
}

class CellsKernels : public testing::Test {
protected:
    void SetUp() override { tests::skip_or_fail_without("opencl"); }

    const Plan plan_ =
        tests::cells_plan(tests::noise_field(40, 30, 5), 0.02, 5, Metric::mean, Boundary::torus);
};

TEST_F(CellsKernels, AreLaunchedAFewTimesARoundNeverOnceASample) {
    std::uint64_t launches = 0;
    const Outcome outcome = run(plan_, cells_kernel_source(), &launches);
    EXPECT_TRUE(outcome.samples == on_cpu(plan_));
    // locate_in_cells, sort_columns, look_up_radii, eight passes, subtract_in_cells.
    EXPECT_GE(launches, 12 * outcome.rounds);
    EXPECT_LE(launches, 14 * outcome.rounds);
}

TEST_F(CellsKernels, ShareTheLinesNearASampleOutAsTheyAreTold) {
    const std::vector<Sample> right = on_cpu(plan_);
    for (const std::uint32_t slices : {2u, 3u, 64u, 10'000u})
        EXPECT_TRUE(run(plan_, "", nullptr, {0, slices}).samples == right) << slices;
}

TEST_F(CellsKernels, ThatAreWrongAreNoticed) {
    const std::vector<Sample> right = on_cpu(plan_);
    ASSERT_TRUE(run(plan_, cells_kernel_source()).samples == right);
    const std::pair<const char*, const char*> faults[] = {
        // locate_cells.cl
        {"bit_of_rank(word, draw.y - passed)", "bit_of_rank(word, (draw.y - passed) / 2u)"},
        {"(line, at * 32u +", "(line, at * 31u +"},
        {"pixel_radii[column_of[candidate.x] * rows + row_of[candidate.y]]",
         "pixel_radii[column_of[candidate.x] * rows]"},
        // admit_cells.cl
        {"if (other.w >= candidate.w) continue;", "if (other.w <= candidate.w) continue;"},
        {"return waits ? FATE_UNDECIDED", "return false ? FATE_UNDECIDED"},
        {"begin = middle + 1u", "begin = middle + 2u"},
        {"k < columns.count", "k < 1u"},
        {"window < windows", "window < 1u"},
        {"radius, candidate_radii[j])", "radius, radius)"},
        {"candidate.x, candidate.y, g.period_x, g.period_y,", "candidate.x, candidate.y, 0u, 0u,"},
        // subtract_cells.cl
        {"cut->radius, pixel)", "cut->radius, cut->radius)"},
        {"max(below, above)", "min(below, above)"},
        {"across * across + up * up < limit", "across * across + up * up <= limit"},
        {"y - reach + 1)", "y - reach + 2)"},
        {"min(end, y + reach));", "min(end, y + reach - 1));"},
        {"pixel_begin, y + shift,", "pixel_begin, y,"},
        {"k < near.count", "k < near.count / 2u"},
        {"any_set(line_begin, begin, end, bits)", "any_set(line_begin, begin, begin, bits)"},
        {"class_bound(pixel_radii[pixel_begin + row])", "1u"},
        {"if (line_begin + word != cut->word) {", "if (line_begin + word > cut->word + 1u) {"},
    };
    for (const auto& [from, to] : faults)
        EXPECT_TRUE(run(plan_, altered(from, to)).samples != right) << from << " became " << to;
}

// What a driver that ends loops early would leave behind, by kernel.
TEST_F(CellsKernels, WhoseLoopsAreEndedEarlyAreAnErrorAndNeverASet) {
    const std::pair<const char*, const char*> jobs[] = {
        {"FAILED_LOCATE", "locate"},
        {"FAILED_SORT_COLUMNS", "sort_columns"},
        {"FAILED_ADMIT", "admit"},
        {"FAILED_SUBTRACT", "subtract"},
    };
    // locate.cl, whose sort_columns cells has too, comes with another check of FAILED_LOCATE.
    const std::string source = cells_kernel_source();
    const std::string cells = source.substr(source.find("kernel void locate_in_cells"));
    for (const auto& [flag, job] : jobs) {
        const std::string raises = "atomic_or(failure, " + std::string(flag) + ");";
        const std::string check = "if (!has_turns_left(g.height)) " + raises;
        const std::size_t at = source.find(
            check, std::string(flag) == "FAILED_LOCATE" ? source.size() - cells.size() : 0);
        ASSERT_NE(at, std::string::npos) << flag;
        std::string changed = source;
        changed.replace(at, check.size(), raises);
        expect_ended_early(plan_, changed, job);
    }
}

TEST_F(CellsKernels, RefuseToRefine) {
    const auto backend = make_backend(plan_, {});
    EXPECT_THROW(backend->refine(true), std::logic_error);
}

// One round whose subtraction takes several slices: some 0.1 s.
TEST_F(CellsKernels, CanBeCancelledInTheMidstOfASubtraction) {
    const Field field = tests::constant_field(1, 1);
    const Plan plan = tests::cells_plan(field, 0.002, 10, Metric::min, Boundary::torus);
    tests::Chance chance(31);
    const std::vector<Draw> draws =
        tests::random_draws(plan, tests::empty_memory(plan), chance, 100'000);
    const auto backend = make_backend(plan, {});
    int asked = 0;
    backend->locate(draws);
    backend->admit();
    backend->watch([&] { return ++asked > 0; });
    backend->subtract();
    const int asked_by_subtract = asked;
    EXPECT_GT(asked_by_subtract, 2);
    for (int allowed = 0; allowed < asked_by_subtract; ++allowed) {
        asked = 0;
        backend->watch([&] { return ++asked <= allowed; });
        EXPECT_THROW(backend->subtract(), Cancelled) << allowed;
        EXPECT_EQ(asked, allowed + 1);
    }
}

struct SmallSet {
    const char* name;
    Metric metric;
    Boundary boundary;
    std::uint32_t slices;
};

// Under Oclgrind too, see oclgrind.cmake: it takes a buffer for uninitialized that lies where one
// was released. So each makes one backend in its process, and rounds of one size.
class CellsSmallSet : public testing::TestWithParam<SmallSet> {
protected:
    void SetUp() override {
        for (const DeviceEntry& entry : list_devices())
            if (entry.unusable.empty()) return;
        if (tests::is_required("opencl")) FAIL() << "LACUNA_REQUIRE has opencl, but no device";
        GTEST_SKIP() << "no device";
    }
};

TEST_P(CellsSmallSet, IsTheCpusToo) {
    Plan plan =
        tests::cells_plan(tests::ramp_field(7, 9), 0.06, 4, GetParam().metric, GetParam().boundary);
    plan.round_size = 16;
    const std::vector<Sample> right = on_cpu(plan);
    EXPECT_GT(right.size(), 16u);
    EXPECT_TRUE(run(plan, "", nullptr, {0, GetParam().slices}).samples == right);
}

INSTANTIATE_TEST_SUITE_P(Metric, CellsSmallSet,
                         testing::Values(SmallSet{"min", Metric::min, Boundary::torus, 1},
                                         SmallSet{"mean", Metric::mean, Boundary::box, 3},
                                         SmallSet{"max", Metric::max, Boundary::torus, 2}),
                         [](const auto& set) { return set.param.name; });

}  // namespace
}  // namespace lacuna::opencl
