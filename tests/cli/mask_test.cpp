// `lacuna mask` writes the ranks of threshold_mask() as a grey PNG of 8 or 16 bits.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <lacuna/threshold_mask.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "expectations.h"
#include "pictures/image.h"
#include "program.h"

namespace mask_test {

using namespace lacuna::tests;

// 256 x 256 ranks are as many as 16 bits have numbers.
TEST(Mask, ComparedWithAGreyIsWhiteInProportionAndBlackAndWhiteStayThemselves) {
    const Folder folder;
    for (const unsigned bits : {8U, 16U}) {
        const std::string path = folder.path("a.png");
        const std::uint32_t side = bits == 8 ? 32 : 256;
        expect_success({"mask", fmt::format("{0}x{0}", side), "--bits", std::to_string(bits),
                        "--quiet", "-o", path});
        const lacuna::pictures::Image image = lacuna::pictures::read_image(path);
        const double pixels = side * side;
        for (const int grey : {0, 1, 100, 254, 255}) {
            const auto white = static_cast<double>(
                std::count_if(image.luminance.begin(), image.luminance.end(),
                              [&](double threshold) { return grey / 255.0 > threshold; }));
            EXPECT_NEAR(white / pixels, grey / 255.0, grey % 255 == 0 ? 0 : 2 / pixels) << grey;
        }
    }
}

TEST(Mask, HasTheRanksInProportionToTheLargestNumber) {
    const Folder folder;
    const std::string path = folder.path("a.png");
    const lacuna::ThresholdMask mask = lacuna::threshold_mask(24, 16, 5);
    for (const unsigned bits : {8U, 16U}) {
        expect_success({"mask", "24x16", "--seed", "5", "--bits", std::to_string(bits), "--quiet",
                        "-o", path});
        const lacuna::pictures::Image image = lacuna::pictures::read_image(path);
        ASSERT_EQ(image.columns, 24U);
        ASSERT_EQ(image.rows, 16U);
        const double most = (1U << bits) - 1;
        for (std::size_t i = 0; i < mask.ranks.size(); ++i)
            ASSERT_EQ(image.luminance[i], std::floor(most * mask.ranks[i] / 384) / most) << i;
    }
}

TEST(Mask, WritesAFileForEachFrame) {
    const Folder folder;
    const lacuna::ThresholdMask mask = lacuna::threshold_mask(12, 8, 5, 11);
    const Outcome outcome = run({"mask", "12x8", "--frames", "11", "--seed", "5", "-o",
                                 folder.path("a{frame}.png"), "-o", folder.path("b{frame}.png")});
    EXPECT_TRUE(outcome.err.starts_with("1056 thresholds of 16 bits in 11 frames -> "))
        << outcome.err;
    EXPECT_EQ(folder.names().size(), 22U);
    for (const std::size_t frame : {0U, 4U, 10U})
        for (const char* const name : {"a", "b"}) {
            const std::string number = (frame < 10 ? "0" : "") + std::to_string(frame);
            const lacuna::pictures::Image image =
                lacuna::pictures::read_image(folder.path(name + number + ".png"));
            for (std::size_t i = 0; i < 96; ++i)
                ASSERT_EQ(image.luminance[i],
                          (mask.ranks[frame * 96 + i] * 65535U / 1056) / 65535.0);
        }
}

TEST(Mask, OfOneFrameSaysSo) {
    const Folder folder;
    const Outcome outcome = run({"mask", "8x8", "--frames", "1", "-o", folder.path("{frame}.png")});
    EXPECT_TRUE(outcome.err.starts_with("64 thresholds of 16 bits in 1 frame -> ")) << outcome.err;
}

}  // namespace mask_test
