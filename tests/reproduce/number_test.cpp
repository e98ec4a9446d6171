// Whether a number is within its band, and its line of output.
#include "reproduce/number.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>

namespace {

using namespace lacuna::reproduce;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

TEST(Numbers, OfThePaperHoldUpToTheirPercentageAndNotBeyond) {
    EXPECT_TRUE(printed("", 1000, 1005, 0.5).within());
    EXPECT_TRUE(printed("", 1000, 995, 0.5).within());
    EXPECT_FALSE(printed("", 1000, 1005.001, 0.5).within());
    EXPECT_FALSE(printed("", 1000, 994.999, 0.5).within());
}

TEST(Numbers, BelowZeroHaveTheirBandAroundThem) {
    EXPECT_TRUE(printed_about("", -10, -9.75, 0.3).within());
    EXPECT_FALSE(printed_about("", -10, -9.69, 0.3).within());
    EXPECT_FALSE(printed_about("", -10, 10, 0.3).within());
}

TEST(Numbers, ThatAreNoNumbersAreNotWithin) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(printed("", 1000, nan, 0.5).within());
    EXPECT_FALSE(in_words("", "more", nan, {0, kInfinite}).within());
}

TEST(Numbers, OfTimeDecideNothing) {
    EXPECT_TRUE(timing("", 26.7, 1e9).within());
}

TEST(Numbers, AreAllWithinUnlessOneIsNot) {
    std::array numbers{printed("a", 100, 100, 1), printed("b", 100, 100, 1), timing("c", 1, 2)};
    EXPECT_TRUE(all_within(numbers));
    numbers[1].here = 102;
    EXPECT_FALSE(all_within(numbers));
}

void expect_has(const std::string& line, const std::string& piece) {
    EXPECT_NE(line.find(piece), std::string::npos) << piece << " in: " << line;
}

TEST(LinesOfNumbers, TellPaperHereDifferenceBandAndVerdict) {
    const std::string line = line_of("table1", printed("samples", 7030.3, 7065.4515, 0.5));
    EXPECT_TRUE(line.starts_with("table1 ")) << line;
    for (const char* piece : {"samples", "paper 7030.3 ", "here 7065.45 ", "+0.50 %",
                              "band 6995.15 to 7065.45: within"})
        expect_has(line, piece);
    expect_has(line_of("", printed("", 7030.3, 7100, 0.5)), ": NOT WITHIN");
    expect_has(line_of("", printed_about("", -10, -9.5, 0.3)), "+0.5 ");
}

TEST(LinesOfNumbers, QuoteWords) {
    const std::string line = line_of("fig5", in_words("line", "bias", 2.5, {1.25, kInfinite}));
    for (const char* piece : {"paper \"bias\"", "here 2.5 ", "band at least 1.25: within"})
        expect_has(line, piece);
    expect_has(line_of("", in_words("", "less", 2.5, {-kInfinite, 1})), "band at most 1: NOT");
}

TEST(LinesOfNumbers, SetTimesBesideThePapersWithoutABand) {
    const std::string line = line_of("table1", timing("s", 20, 5));
    for (const char* piece : {"paper 20 ", "here 5 ", "0.25 times", "band none: decides nothing"})
        expect_has(line, piece);
}

}  // namespace
