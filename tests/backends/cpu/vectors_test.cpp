// The loops for the processor's vectors give the numbers of the portable arithmetic.
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
#include "portable/status.h"

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
    // Four rows of each of four columns. Other rows, whose samples must not count, lie in between.
    constexpr std::size_t kStride = 7;
    int closer = 0;
    for (std::size_t i = 0; i < 200'000; ++i) {
        const std::uint32_t r = kRadii[i % std::size(kRadii)];
        const Sample middle{r + below((1u << 31) - 2 * r), r + below((1u << 31) - 2 * r)};
        std::vector<Sample> cells(4 * kStride, middle);
        for (std::size_t column = 0; column < 4; ++column)
            for (std::size_t row = 0; row < 4; ++row)
                cells[column * kStride + row] = below(2) == 0 ? kNone : kMark;
        // At most one sample is at about the radius' distance, in any direction.
        const std::uint32_t dx = below(r + 1);
        const auto dy = static_cast<std::uint32_t>(
            portable::isqrt(std::uint64_t{r} * r - std::uint64_t{dx} * dx));
        const std::uint32_t off = below(4);
        const Sample near{below(2) == 0 ? middle.x + dx : middle.x - dx,
                          below(2) == 0 ? middle.y + dy + off - 1 : middle.y - dy - off + 1};
        if (below(4) != 0) cells[below(4) * kStride + below(4)] = near;
        const bool expected = std::any_of(cells.begin(), cells.end(), [&](const Sample& cell) {
            const auto at = static_cast<std::size_t>(&cell - cells.data());
            return at % kStride < 4 && cell.x != NO_SAMPLE &&
                   portable::are_closer(middle.x, middle.y, cell.x, cell.y, 0, 0,
                                        std::uint64_t{r} * r);
        });
        ASSERT_EQ(GetParam()->is_any_closer(cells.data(), kStride, middle, std::uint64_t{r} * r),
                  expected)
            << "radius " << r << ", " << near.x << " " << near.y << " from " << middle.x << " "
            << middle.y;
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
            // The chord's exact length is a whole number, or the distance is a unit off that.
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

// Samples of all radii around a point, some at about the limit. The padding must not count.
SizedList samples_around(Sample middle, std::uint32_t period, std::mt19937_64& random) {
    const auto below = [&](std::uint64_t end) {
        return static_cast<std::uint32_t>(random() % end);
    };
    SizedList samples;
    for (std::uint32_t count = below(45); count > 0; --count) {
        const std::uint32_t radius = 1 + below(std::uint64_t{1} << (4 + below(27)));
        const std::uint32_t dx = below(std::uint64_t{radius} + 1);
        const auto dy = static_cast<std::uint32_t>(
            portable::isqrt(std::uint64_t{radius} * radius - std::uint64_t{dx} * dx));
        const auto at = [&](std::uint32_t from, std::uint32_t far) {
            const std::uint64_t moved = below(2) == 0 ? std::uint64_t{from} + far + below(3)
                                                      : std::uint64_t{from} + period - far % period;
            return static_cast<std::uint32_t>(moved % period);
        };
        samples.push_back({at(middle.x, dx), at(middle.y, dy), radius});
    }
    SizedList padded = samples;
    for (std::size_t i = 0; i < kVectorPadding; ++i)
        padded.push_back({middle.x, middle.y, ~std::uint32_t{0} - below(2)});
    return padded;
}

TEST_P(OfVectors, ASampleIsCloserThanTheSmallerRadiusOrNot) {
    int closer = 0;
    for (int i = 0; i < 100'000; ++i) {
        const std::uint32_t length = below(2) == 0 ? 1u << 30 : 3 + below(1u << 30);
        const std::uint32_t period = below(2) == 0 ? length : 0;
        const Sample middle{below(length), below(length)};
        const SizedList padded = samples_around(middle, length, random_);
        const SizedSpan samples = padded.span().part(0, padded.size() - kVectorPadding);
        const std::uint32_t radius = 1 + below(std::uint64_t{1} << (4 + below(27)));
        bool expected = false;
        for (std::size_t k = 0; k < samples.count; ++k) {
            const std::uint64_t limit = std::min(samples.radius[k], radius);
            expected |= portable::are_closer(samples.x[k], samples.y[k], middle.x, middle.y, period,
                                             period, limit * limit);
        }
        ASSERT_EQ(GetParam()->is_any_sized_closer(samples, middle, radius, {period, period}),
                  expected);
        closer += expected ? 1 : 0;
    }
    EXPECT_GT(closer, 10'000);
    EXPECT_LT(closer, 90'000);
}

TEST_P(OfVectors, SamplesTouchAndCoverBoxes) {
    constexpr std::uint32_t kLength = 1u << 30;
    int touched = 0;
    int covered = 0;
    for (int turn = 0; turn < 50'000; ++turn) {
        const std::uint32_t most = std::uint32_t{2} << below(28);
        const Sample corner{below(kLength - 2 * most), below(kLength - 2 * most)};
        BoxBatch boxes;
        for (std::size_t i = 0; i < BoxBatch::kBoxes; ++i) {
            const std::uint32_t begin = corner.y + below(most);
            boxes.set(i, {corner.x + below(most), 1 + below(most), begin, begin + 1 + below(most)});
        }
        const SizedList padded =
            samples_around({corner.x + most, corner.y + most}, kLength, random_);
        const SizedSpan samples = padded.span().part(0, padded.size() - kVectorPadding);
        std::vector<std::uint32_t> radii(BoxBatch::kBoxes, ~std::uint32_t{0});
        if (below(2) == 0)
            for (std::uint32_t& radius : radii)
                radius = 1 + below(std::uint64_t{1} << (4 + below(27)));
        std::vector<std::uint8_t> touching(samples.count);
        const std::uint32_t all =
            GetParam()->find_touching(samples, boxes, radii.data(), touching.data());
        for (std::size_t i = 0; i < BoxBatch::kBoxes; ++i) {
            const Box box = boxes[i];
            bool is_covered = false;
            for (std::size_t k = 0; k < samples.count; ++k) {
                const auto [x, y, radius] = samples[k];
                const std::uint64_t limit = std::min(radius, radii[i]);
                const std::uint32_t half = box.width / 2;
                const std::uint32_t reach = portable::chord_reach(
                    portable::axis_distance(x, box.x + half, 0) + half, limit * limit);
                const Span chord{portable::window_begin(0, y, reach, 2 * kLength),
                                 portable::window_end(0, y, reach, 2 * kLength)};
                const bool touches = reach != 0 && chord.begin < box.end && chord.end > box.begin;
                ASSERT_EQ((touching[k] >> i & 1) != 0, touches);
                touched += touches ? 1 : 0;
                is_covered |= touches && chord.begin <= box.begin && chord.end >= box.end;
            }
            ASSERT_EQ((all >> i & 1) != 0, is_covered);
            covered += is_covered ? 1 : 0;
        }
    }
    EXPECT_GT(touched, 50'000);
    EXPECT_GT(covered, 10'000);
    EXPECT_LT(covered, 390'000);
}

TEST(Vectors, InPlainWordsServeTheLargestRadii) {
    EXPECT_STREQ(vectors_for(kLargestVectorRadius).name, "plain");
    EXPECT_EQ(&vectors_for(1), all_vectors().front());
}

}  // namespace
}  // namespace lacuna::cpu
