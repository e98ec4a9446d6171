// Floats tell which ellipses touch and cover boxes and hold samples, and never what whole numbers
// deny.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "backends/cpu/vectors.h"
#include "plan/ellipse.h"
#include "portable/conflict.h"

namespace lacuna::cpu {
namespace {

using Random = std::mt19937_64;

double between(Random& random, double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
}

// Ratios of up to 32, and some of up to 1000.
portable::Ellipse any_ellipse(Random& random, double longest) {
    const double longer = longest * std::exp2(-between(random, 0, 3));
    const double ratio = std::exp(between(random, 0, std::log(random() % 4 == 0 ? 1000 : 32)));
    return rounded({longer, std::max(4.0, longer / ratio), between(random, -4, 4)},
                   {1, 1, 1, 0x1p31})
        .ellipse;
}

constexpr std::uint32_t kMiddle = std::uint32_t{1} << 29;

std::uint32_t beside_middle(Random& random, double most) {
    return kMiddle + static_cast<std::uint32_t>(std::llround(between(random, -most, most)));
}
// Some are 1 unit wide or high.
Box any_box(Random& random, double most) {
    const auto length = [&] {
        return 1 + static_cast<std::uint32_t>(most * std::exp2(-between(random, 0, 16)));
    };
    const std::uint32_t x = beside_middle(random, most), begin = beside_middle(random, most);
    return {x, length(), begin, begin + length()};
}

class EllipsesOfVectors : public testing::TestWithParam<const Vectors*> {};
INSTANTIATE_TEST_SUITE_P(Words, EllipsesOfVectors,
                         testing::ValuesIn(all_vectors().begin(), all_vectors().end()),
                         [](const auto& named) { return std::string(named.param->name); });

struct Counts {
    int touch = 0;
    int cover = 0;
};

TEST_P(EllipsesOfVectors, TouchAndCoverBoxes) {
    Random random(7);
    Counts told, true_counts;
    for (int turn = 0; turn < 50'000; ++turn) {
        const double longest = std::exp2(between(random, 4, 27));
        constexpr std::size_t kSamples = 5;
        SizedList samples;
        std::vector<portable::Ellipse> of_samples;
        std::vector<FloatEllipse> samples_in_floats;
        for (std::size_t k = 0; k < kSamples; ++k) {
            samples.push_back(
                {beside_middle(random, longest / 4), beside_middle(random, longest / 4), 0});
            of_samples.push_back(any_ellipse(random, longest));
            samples_in_floats.push_back(in_floats(of_samples.back()));
        }
        BoxBatch boxes;
        std::array<portable::Ellipse, BoxBatch::kBoxes> of_boxes;
        std::array<FloatEllipse, BoxBatch::kBoxes> boxes_in_floats;
        for (std::size_t i = 0; i < BoxBatch::kBoxes; ++i) {
            boxes.set(i, any_box(random, longest / 8));
            of_boxes[i] =
                random() % 2 == 0 ? of_samples[i % kSamples] : any_ellipse(random, 2 * longest);
            boxes_in_floats[i] = in_floats(of_boxes[i]);
        }
        std::array<std::uint8_t, kSamples> touching;
        const std::uint32_t covered =
            GetParam()->find_touching_ellipses(samples.span(), samples_in_floats.data(), boxes,
                                               boxes_in_floats.data(), touching.data());
        for (std::size_t i = 0; i < BoxBatch::kBoxes; ++i) {
            bool is_covered = false;
            for (std::size_t k = 0; k < kSamples; ++k) {
                const auto [x, y, radius] = samples.span()[k];
                const auto [begin, end] = portable::ellipse_chord(x, of_samples[k], boxes[i].x,
                                                                  boxes[i].width, of_boxes[i], 0);
                const std::int64_t low = std::int64_t{boxes[i].begin} - y;
                const std::int64_t high = std::int64_t{boxes[i].end} - y;
                const bool touches = begin < end && begin < high && end > low;
                const bool is_told = (touching[k] >> i & 1) != 0;
                ASSERT_TRUE(is_told || !touches) << "turn " << turn << " box " << i;
                is_covered |= touches && begin <= low && end >= high;
                true_counts.touch += touches ? 1 : 0;
                told.touch += is_told ? 1 : 0;
            }
            const bool is_told = (covered >> i & 1) != 0;
            ASSERT_TRUE(is_covered || !is_told) << "turn " << turn << " box " << i;
            true_counts.cover += is_covered ? 1 : 0;
            told.cover += is_told ? 1 : 0;
        }
    }
    // Floats test the four chords of a sample and a box one by one. So they count a box as touched
    // that all four touch, but at different heights.
    EXPECT_GT(true_counts.touch, 100'000);
    EXPECT_GT(true_counts.cover, 10'000);
    EXPECT_LT(told.touch, 1.05 * true_counts.touch);
    EXPECT_GT(told.cover, .9 * true_counts.cover);
}

TEST_P(EllipsesOfVectors, HoldSamples) {
    Random random(9);
    int held = 0, named = 0;
    for (int turn = 0; turn < 50'000; ++turn) {
        const double longest = std::exp2(between(random, 4, 27));
        const portable::Ellipse e = any_ellipse(random, longest);
        const Sample at{kMiddle, kMiddle};
        const std::size_t count = random() % 20;
        SizedList samples;
        for (std::size_t k = 0; k < count + kVectorPadding; ++k)
            samples.push_back({beside_middle(random, longest), beside_middle(random, longest), 0});
        const SizedSpan near = samples.span().part(0, count);
        std::vector<bool> is_named(count);
        for (std::size_t k = 0;; ++k) {
            k = GetParam()->next_in_ellipse(near, at, in_floats(e), k);
            ASSERT_LE(k, count);
            if (k == count) break;
            is_named[k] = true;
        }
        for (std::size_t k = 0; k < count; ++k) {
            const bool is_held =
                portable::holds(e, std::int64_t{near.x[k]} - at.x, std::int64_t{near.y[k]} - at.y);
            ASSERT_TRUE(is_named[k] || !is_held) << "turn " << turn << " sample " << k;
            held += is_held ? 1 : 0;
            named += is_named[k] ? 1 : 0;
        }
    }
    EXPECT_GT(held, 10'000);
    EXPECT_LT(named, 1.01 * held);
}

}  // namespace
}  // namespace lacuna::cpu
