// Before the first sample, spans, free lengths and bits agree.
#include "plan/first_free.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "backends/cells_scenes.h"

namespace lacuna {
namespace {

TEST(FirstBits, AreSetWhereThereIsImportance) {
    for (const tests::Scene& scene : tests::random_cells_scenes()) {
        const std::vector<std::uint32_t> expected = tests::empty_memory(scene.plan).bits;
        EXPECT_EQ(words_per_line(scene.plan), tests::words_of_line(scene.plan)) << scene.name;
        for (const std::uint32_t step : {1u, 7u, scene.plan.lines}) {
            std::vector<std::uint32_t> bits;
            for (std::uint32_t line = 0; line < scene.plan.lines; line += step) {
                const std::uint32_t end = line + std::min(step, scene.plan.lines - line);
                const std::vector<std::uint32_t> part = first_bits(scene.plan, line, end);
                bits.insert(bits.end(), part.begin(), part.end());
            }
            EXPECT_TRUE(bits == expected) << scene.name << ", parts of " << step << " lines";
        }
    }
}

TEST(FirstSpans, HoldThePlacesOfTheBitsAndNoOther) {
    for (const tests::Scene& scene : tests::random_cells_scenes()) {
        const Plan& plan = scene.plan;
        const std::vector<std::uint32_t> lengths = first_free_lengths(plan);
        for (std::uint32_t x = 0; x < plan.lines; ++x) {
            std::vector<bool> is_free(plan.height, false);
            std::uint32_t length = 0;
            std::uint32_t end_of_last = 0;
            for (const Span span : first_spans(plan, x)) {
                ASSERT_LT(span.begin, span.end) << scene.name << ", line " << x;
                ASSERT_TRUE(span.begin > end_of_last || length == 0)
                    << scene.name << ", line " << x;
                std::fill(is_free.begin() + span.begin, is_free.begin() + span.end, true);
                length += span.end - span.begin;
                end_of_last = span.end;
            }
            EXPECT_EQ(lengths[x], length) << scene.name << ", line " << x;
            for (std::uint32_t y = 0; y < plan.height; ++y)
                ASSERT_EQ(is_free[y], tests::has_importance(plan, x, y))
                    << scene.name << " at " << x << ", " << y;
        }
    }
}

TEST(FirstSpans, AreWholeLinesWhereDensityIsUniform) {
    for (const Mode mode : {Mode::exact, Mode::lines}) {
        const Plan plan = tests::plan_of(0.1, 5, Boundary::box, 1, 1, mode);
        EXPECT_EQ(first_spans(plan, plan.lines - 1), (std::vector<Span>{{0, plan.height}}));
        EXPECT_EQ(first_free_lengths(plan), std::vector<std::uint32_t>(plan.lines, plan.height));
    }
}

}  // namespace
}  // namespace lacuna
