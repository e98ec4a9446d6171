// Draws inverted together equal draws inverted one by one, then sorted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/workers.h"
#include "plan/make_plan.h"
#include "plan/plan.h"
#include "rounds/marginal.h"
#include "rounds/random.h"

namespace {

using namespace lacuna;

constexpr std::uint32_t kBinWidth = 1000;

// Section 3, word for word: walks from the first bin until the weight is used up.
Draw inverted_alone(const std::vector<std::uint32_t>& lengths, std::uint64_t total,
                    const Plan& plan, std::uint64_t number) {
    const auto u32 = [](std::uint64_t value) { return static_cast<std::uint32_t>(value); };
    const RandomBits random = random_bits(plan.seed, number);
    std::uint64_t c = scaled(random.first, total);
    std::uint32_t bin = 0;
    const auto weight = [&] { return plan.is_uniform_x() ? (lengths[bin] != 0) : lengths[bin]; };
    for (; c >= weight(); ++bin) c -= weight();
    if (!plan.is_uniform_x()) return {bin, u32(c), u32(scaled(random.second, kBinWidth)), 0};
    const std::uint64_t bits = random_bits(plan.seed, number, 1).first;
    return {bin, u32(scaled(random.second, lengths[bin])), u32(scaled(bits, kBinWidth)), 0};
}

// Few draws in many bins, many in few, and parts of more than one size.
void expect_draws_inverted_alone(std::size_t bins, std::uint32_t count, bool uniform_x) {
    SCOPED_TRACE(testing::Message()
                 << count << " draws, " << bins << " bins" << (uniform_x ? ", uniform-x" : ""));
    constexpr std::uint64_t kFirst = 12'345;
    Request request;
    request.mode = Mode::lines;
    request.radius = 0.1;
    request.seed = 5;
    request.paper2011.uniform_x = uniform_x;
    const Plan plan = make_plan(request);
    std::vector<std::uint32_t> lengths(bins);
    for (std::size_t i = 0; i < bins; ++i)  // also runs of empty bins
        lengths[i] = i % 7 < 3 ? 0 : static_cast<std::uint32_t>(1 + i * 7919 % 100);
    lengths[bins / 2] = 1'000'000;
    Workers workers(3);
    Marginal marginal(plan, workers, [] {});
    marginal.rebuild(lengths, kBinWidth);

    const std::span<const Draw> draws = marginal.invert(kFirst, count);

    ASSERT_EQ(draws.size(), count);
    EXPECT_TRUE(std::is_sorted(draws.begin(), draws.end(), [](const Draw& a, const Draw& b) {
        return a.bin != b.bin ? a.bin < b.bin : a.rank < b.rank;
    }));
    std::vector<bool> seen(count);
    for (const Draw& draw : draws) {
        ASSERT_FALSE(seen.at(draw.order));
        seen[draw.order] = true;
        Draw expected = inverted_alone(lengths, marginal.total(), plan, kFirst + draw.order);
        expected.order = draw.order;
        ASSERT_EQ(draw, expected);
    }
}

TEST(Marginal, InvertsEachDrawAsIfAlone) {
    for (const bool uniform_x : {false, true})
        for (const std::size_t bins : {1u, 16u, 17u, 1000u})
            for (const std::uint32_t count : {1u, 2u, 300u, 4096u, 20'000u})
                expect_draws_inverted_alone(bins, count, uniform_x);
}

TEST(Marginal, InvertsFewDrawsInManyBins) {
    for (const std::uint32_t count : {1u, 7u, 100u})
        expect_draws_inverted_alone(100'000, count, false);
}

// Ranks that each hold a part of a cdf together make the draws of one process, each draw once.
TEST(Marginal, SharesMakeTheDrawsOfTheWhole) {
    Request request;
    request.radius = 0.1;
    request.seed = 5;
    const Plan plan = make_plan(request);
    constexpr std::uint64_t kFirst = 12'345;
    constexpr std::uint32_t kCount = 30'000;
    std::vector<std::uint32_t> lengths(1000);
    for (std::size_t i = 0; i < lengths.size(); ++i)
        lengths[i] = static_cast<std::uint32_t>(i * 7919 % 100);
    Workers workers(2);
    Marginal whole(plan, workers, [] {});
    whole.rebuild(lengths, kBinWidth);
    const std::span<const Draw> all = whole.invert(kFirst, kCount);
    std::vector<Draw> expected(all.begin(), all.end());

    // The second and the last rank have nothing.
    std::vector<Draw> made;
    std::uint64_t before = 0;
    std::uint32_t bin = 0;
    for (const std::uint32_t end : {400u, 400u, 401u, 900u, 1000u, 1000u}) {
        Marginal part(plan, workers, [] {});
        const std::span<const std::uint32_t> own = std::span(lengths).subspan(bin, end - bin);
        part.rebuild(own, kBinWidth);
        const std::span<const Draw> draws = part.invert(kFirst, kCount, {before, whole.total()});
        std::vector<bool> seen(draws.size());
        for (const Draw& draw : draws) {
            ASSERT_FALSE(seen.at(draw.order));
            seen[draw.order] = true;
            made.push_back({draw.bin + bin, draw.rank, draw.offset, part.number_of(draw.order)});
        }
        before += part.total();
        bin = end;
    }

    EXPECT_TRUE(made == expected);
}

}  // namespace
