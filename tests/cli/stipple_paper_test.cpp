// Given paper, all ink of `lacuna stipple` lies within its margins.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "cli/stippling.h"
#include "pictures/image.h"
#include "program.h"

namespace {

using namespace lacuna::tests;

// How far ink is from the nearest edge of a picture, in pixels.
std::size_t margin_of(const lacuna::pictures::Image& picture) {
    constexpr double kInk = 0.9;  // darker than the edge of a dot that cairo smooths
    std::size_t margin = picture.columns;
    for (std::size_t row = 0; row < picture.rows; ++row)
        for (std::size_t column = 0; column < picture.columns; ++column)
            if (picture.luminance[row * picture.columns + column] < kInk)
                margin = std::min(
                    {margin, row, picture.rows - 1 - row, column, picture.columns - 1 - column});
    return margin;
}

TEST(OnPaper, AllInkLiesWithinTheMarginInEveryWayOfDrawing) {
    const Folder folder;
    const std::string path = folder.path("a.png");
    // Diagonal bars up to the edges; a pixel is 0.1 mm.
    std::string pixels;
    for (int i = 0; i < 60 * 40; ++i) pixels += static_cast<char>((i % 60 + i / 60) % 16 * 8);
    const Names sheet{"stipple", grey_picture(folder, 60, 40, pixels),
                      "--dpi",   "254",
                      "--quiet", "--paper-size",
                      "80x70mm", "--margin",
                      "12mm",    "-o",
                      path};
    for (const Names& way :
         {Names{"--count", "300"}, Names{"--count", "300", "--size-by-tone", "1"},
          Names{"--count", "300", "--relax", "0"}, Names{"--count", "300", "--along", "5"},
          Names{"--count", "300", "--inks", "red,blue"}, Names{"--dot-size", "1mm"},
          Names{"--pens", "0.5mm,1mm,2mm"}, Names{"--inks", "black:0.5mm,red:2mm"},
          Names{"--along", "6", "--dot-size", "0.5mm", "--count", "100"},
          Names{"--path-line", "--count", "300"}, Names{"--path-line", "--dot-size", "1mm"}}) {
        ASSERT_EQ(run(joined(sheet, way)).exit_code, 0) << way.back();
        const std::size_t margin = margin_of(lacuna::pictures::read_image(path));
        EXPECT_GE(margin, 119U) << way.back();
        EXPECT_LE(margin, 127U) << way.back() << ": as large as the margin allows";
    }
    expect_one_error(run(joined(sheet, {"--dot-size", "50mm"})), 2,
                     {"--margin 12mm: leaves no room on the paper for a pen of 50mm"});
}

}  // namespace
