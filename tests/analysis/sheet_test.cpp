// Given an analysis, its sheet is a picture of it alone, with the same bytes each time.
#include "analysis/sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "analysis/sets.h"
#include "drawing/plot.h"
#include "files/point_files.h"
#include "pdf_text.h"
#include "text.h"

namespace lacuna::analysis {
namespace sheet_test {

using files::Medium;
using tests::contains;
using tests::occurrences;

std::string sheet_of(const Sets& sets, Medium medium, const Domain& domain = {1, 1, true}) {
    return draw_sheet(analyse(sets, domain, {}, carry_on), sets.front(), medium);
}

Sets ten_sets() {
    Sets sets;
    for (std::uint64_t seed = 0; seed < 10; ++seed)
        sets.push_back(white_noise(300, {1, 1, true}, seed));
    return sets;
}

TEST(SheetAsSvg, ShowsThePointsOfTheFirstSetAndTheReferenceOfSoManySets) {
    const std::string ten = sheet_of(ten_sets(), Medium::svg);
    EXPECT_TRUE(ten.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg "));
    EXPECT_TRUE(ten.ends_with("</svg>\n"));
    EXPECT_EQ(occurrences(ten, "h0.01\n"), 300U);
    EXPECT_TRUE(contains(ten, "10 sets of 300 points, torus 1 \u00d7 1"));
    EXPECT_TRUE(contains(ten, "\u221210 dB: 10 sets without direction"));
    EXPECT_TRUE(contains(ten, "data:image/png;base64,iVBORw0KGgo"));

    const std::string one = sheet_of({ten_sets().front()}, Medium::svg);
    EXPECT_TRUE(contains(one, ">300 points, torus"));
    EXPECT_TRUE(contains(one, ">0 dB: 1 set without direction"));
}

TEST(SheetAsSvg, ShowsPointsAtTheirPlacesWithYUpwards) {
    // The panel of points is 252 points wide and high, its upper left corner at (52, 66).
    const std::string svg = sheet_of({{{0.25, 0.125}}}, Medium::svg);
    EXPECT_TRUE(contains(svg, "M115.000 286.500h0")) << svg;
    // From the corner on, which the axes name.
    const Domain away{.width = 1, .height = 1, .torus = true, .x0 = 448000, .y0 = -3.5};
    const std::string moved = sheet_of({{{448000.25, -3.375}}}, Medium::svg, away);
    EXPECT_TRUE(contains(moved, "M115.000 286.500h0")) << moved;
    EXPECT_TRUE(contains(moved, ">x \u2212 448000<"));
    EXPECT_TRUE(contains(moved, ">y + 3.5<"));
}

// Squares of 12 x 12 have no power below the first peak.
TEST(SheetAsSvg, ShowsLowPowersOnALogarithmicAxis) {
    std::vector<Point> lattice;
    for (int i = 0; i < 144; ++i) lattice.push_back({(i % 12) / 12.0, (i / 12) / 12.0});
    EXPECT_TRUE(contains(sheet_of({lattice}, Medium::svg), "1e\u22125<"));
    EXPECT_FALSE(contains(sheet_of(ten_sets(), Medium::svg), ">1e\u2212"));
}

TEST(SheetAsSvg, KeepsTheShapeOfTheDomain) {
    const std::string svg =
        sheet_of({white_noise(50, {4, 1, false}, 1)}, Medium::svg, {4, 1, false});
    EXPECT_TRUE(contains(svg, "box 4 \u00d7 1"));
    EXPECT_TRUE(contains(svg, "width=\"252.00\" height=\"63.00\" fill=\"none\"")) << svg;
}

TEST(SheetAsPdf, IsOnePageWithoutTheTimeOfDay) {
    const std::string pdf = tests::pdf_text(sheet_of(ten_sets(), Medium::pdf));
    EXPECT_TRUE(pdf.starts_with("%PDF-1."));
    EXPECT_TRUE(contains(pdf, "/CreationDate (20000101000000Z)"));
    EXPECT_TRUE(contains(pdf, "/Count 1\n"));
}

class Sheet : public testing::TestWithParam<Medium> {};

TEST_P(Sheet, WhenDrawnTwiceHasTheSameBytes) {
    const Sets sets = ten_sets();
    EXPECT_EQ(sheet_of(sets, GetParam()), sheet_of(sets, GetParam()));
}

TEST_P(Sheet, WhenASetDiffersHasOtherBytes) {
    Sets sets = ten_sets();
    const std::string before = sheet_of(sets, GetParam());
    sets.back() = white_noise(300, {1, 1, true}, 99);
    EXPECT_NE(sheet_of(sets, GetParam()), before);
}

TEST_P(Sheet, OfAWhollyRegularSetOrOnePointIsStillDrawn) {
    EXPECT_FALSE(sheet_of({grid(16, 16, {1, 1, true})}, GetParam()).empty());
    EXPECT_FALSE(sheet_of({{{0.5, 0.5}}}, GetParam()).empty());
    EXPECT_FALSE(
        sheet_of({white_noise(30, {1000, 1, true}, 1)}, GetParam(), {1000, 1, true}).empty());
}

INSTANTIATE_TEST_SUITE_P(Formats, Sheet, testing::Values(Medium::svg, Medium::pdf, Medium::png),
                         [](const testing::TestParamInfo<Medium>& medium) {
                             return medium.param == Medium::svg   ? "Svg"
                                    : medium.param == Medium::pdf ? "Pdf"
                                                                  : "Png";
                         });

TEST(Ticks, AreRoundNumbersWithinTheAxis) {
    EXPECT_EQ(drawing::ticks_of(0, 2, 4), (std::vector<double>{0, 0.5, 1, 1.5, 2}));
    EXPECT_EQ(drawing::ticks_of(-25, 5, 3), (std::vector<double>{-20, -10, 0}));
    EXPECT_EQ(drawing::ticks_of(0.3, 6.1, 3), (std::vector<double>{2, 4, 6}));
    EXPECT_EQ(drawing::ticks_of(0, 1, 5).size(), 6U);
    EXPECT_FALSE(std::signbit(drawing::ticks_of(-1, 1, 2)[1]));
}

}  // namespace sheet_test
}  // namespace lacuna::analysis
