// The inner loops for the processor's vectors give the whole numbers of the portable arithmetic.
#include "backends/cpu/vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "portable/chord.h"
#include "portable/distance.h"
#include "portable/fate.h"

namespace lacuna::cpu {
namespace {

constexpr Sample kNone{NO_SAMPLE, NO_SAMPLE};
constexpr Sample kMark{NO_SAMPLE, NO_SAMPLE - 1};
constexpr std::uint32_t kRadii[] = {2'048, 99'991, 1u << 20, 123'456'789, kLargestVectorRadius - 1};

class OfVectors : public testing::TestWithParam<const Vectors*> {
protected:
    std::uint32_t below(std::uint64_t end) { return static_cast<std::uint32_t>(random_() % end); }
    std::mt19937_64 random_{19};
};
INSTANTIATE_TEST_SUITE_P(Words, OfVectors,
                         testing::ValuesIn(all_vectors().begin(), all_vectors().end()),
                         [](const auto& named) { return std::string(named.param->name); });

TEST_P(OfVectors, ASampleIsCloserThanTheRadiusOrNot) {
    // Four columns among others, of which none counts.
    constexpr std::size_t kStride = 7;
    int closer = 0;
    for (std::size_t i = 0; i < 200'000; ++i) {
        const std::uint32_t r = kRadii[i % std::size(kRadii)];
        const Sample place{r + below((1u << 31) - 2 * r), r + below((1u << 31) - 2 * r)};
        std::vector<Sample> cells(4 * kStride, place);
        for (std::size_t column = 0; column < 4; ++column)
            for (std::size_t row = 0; row < 4; ++row)
                cells[column * kStride + row] = below(2) == 0 ? kNone : kMark;
        // One or none is at about the radius' distance, in any direction.
        const std::uint32_t dx = below(r + 1);
        const auto dy = static_cast<std::uint32_t>(
            portable::isqrt(std::uint64_t{r} * r - std::uint64_t{dx} * dx));
        const std::uint32_t off = below(4);
        const Sample near{below(2) == 0 ? place.x + dx : place.x - dx,
                          below(2) == 0 ? place.y + dy + off - 1 : place.y - dy - off + 1};
        if (below(4) != 0) cells[below(4) * kStride + below(4)] = near;
        const bool expected = std::any_of(cells.begin(), cells.end(), [&](const Sample& cell) {
            const auto at = static_cast<std::size_t>(&cell - cells.data());
            return at % kStride < 4 && cell.x != NO_SAMPLE &&
                   portable::conflicts(place.x, place.y, cell.x, cell.y, 0, 0,
                                       std::uint64_t{r} * r);
        });
        ASSERT_EQ(GetParam()->is_any_closer(cells.data(), kStride, place, std::uint64_t{r} * r),
                  expected)
            << "radius " << r << ", " << near.x << " " << near.y << " from " << place.x << " "
            << place.y;
        closer += expected ? 1 : 0;
    }
    EXPECT_GT(closer, 20'000);
    EXPECT_LT(closer, 180'000);
}

TEST_P(OfVectors, ChordsAreThoseOfTheirDistances) {
    for (std::size_t i = 0; i < 40'000; ++i) {
        const std::uint32_t r = kRadii[i % std::size(kRadii)];
        const std::uint64_t radius_squared = std::uint64_t{r} * r;
        const std::uint32_t height = below(4) == 0 ? 1 + below(r) : 1 + below(1u << 31);
        std::vector<Seen> seen(below(20));
        for (Seen& one : seen) {
            one = {below(r), below(2) == 0 ? below(height) : height - 1};
            // A chord of a whole number's length, or a unit beside one.
            const std::uint64_t t = below(r);
            const auto dx = static_cast<std::uint32_t>(portable::isqrt(radius_squared - t * t));
            if (below(2) == 0) one.distance = std::min(dx + 1 - below(2), r - 1);
            if (below(8) == 0) one.distance = below(2) == 0 ? 0 : r - 1;
        }
        const std::size_t count = seen.size();
        seen.resize(count + kVectorPadding, {~std::uint32_t{0}, ~std::uint32_t{0}});
        std::vector<Span> chords(seen.size());
        GetParam()->find_chords(std::span(seen).first(count), radius_squared, height,
                                chords.data());
        for (std::size_t k = 0; k < count; ++k) {
            const std::uint32_t reach = portable::chord_reach(seen[k].distance, radius_squared);
            const Span expected{portable::window_begin(0, seen[k].y, reach, height),
                                portable::window_end(0, seen[k].y, reach, height)};
            ASSERT_EQ(chords[k].begin, expected.begin) << r << " " << seen[k].distance;
            ASSERT_EQ(chords[k].end, expected.end) << r << " " << seen[k].distance;
        }
    }
}

TEST(Vectors, InPlainWordsServeTheLargestRadii) {
    EXPECT_STREQ(vectors_for(kLargestVectorRadius).name, "plain");
    EXPECT_EQ(&vectors_for(1), all_vectors().front());
}

}  // namespace
}  // namespace lacuna::cpu
