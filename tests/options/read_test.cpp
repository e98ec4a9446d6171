// Texts become values of options, and values texts again.
#include "options/read.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/number_text.h"
#include "options/describe.h"
#include "options/targets.h"
#include "refusal.h"

namespace lacuna::options {
namespace {

// The option and the value that are refused; the messages are in tests/refusals.txt.
template <typename Act>
std::string refused_of(Act act) {
    const std::string message = tests::refusal_of(act);
    return message.substr(0, message.find(": "));
}

TEST(WholeNumbers, MayBeShortOrInGroupsOfThreeDigits) {
    const std::map<std::string, std::uint64_t> taken{
        {"0", 0},
        {"20000", 20000},
        {"007", 7},
        {"2e4", 20000},
        {"2E4", 20000},
        {"2e+4", 20000},
        {"1.5e1", 15},
        {"20k", 20000},
        {"20K", 20000},
        {"1.5M", 1500000},
        {"2G", 2000000000},
        {".5k", 500},
        {"5.k", 5000},
        {"1.001M", 1001000},
        {"20,000", 20000},
        {"1,500,000", 1500000},
        {"20_000", 20000},
        {"20'000", 20000},
        {"20 000", 20000},
        {"999,999", 999999},
        {"18446744073709551615", 18446744073709551615U}};
    for (const auto& [text, number] : taken) {
        std::uint64_t value = 1;
        read("seed", text, value);
        EXPECT_EQ(value, number) << text;
    }
    for (const std::string text : {"",        " ",         "k",        ",",
                                   "20,00",   "2,0000",    "20,000,",  ",000",
                                   "1,,000",  "1,000_000", "+5",       "1,000k",
                                   "1,000.0", "1.5",       "1234,567", "1,000.5k",
                                   "1e-3",    "-1",        "-0",       "-2k",
                                   "2kk",     "2e3k2",     "2e1k",     "1e40",
                                   "nan",     "inf",       "0x10",     "5 k",
                                   " 5",      "1.000.000", "many",     "18446744073709551616",
                                   "10.000",  "1.500",     "1,000.000"}) {
        std::uint64_t value = 0;
        EXPECT_EQ(refused_of([&] { read("seed", text, value); }), "seed " + shown(text));
    }
    double radius = 0;
    read("radius", "0.125", radius);
    EXPECT_EQ(radius, 0.125);
}

TEST(Numbers, AreReadAsAWhole) {
    double value = 0;
    read("radius", "-1e-2", value);
    EXPECT_EQ(value, -0.01);
    for (const std::string text : {"", "5x", "0x1", " 0.1", "0.1 ", "1\n2", "+1", "1,5", "1e400"})
        EXPECT_EQ(refused_of([&] { read("radius", text, value); }), "radius " + shown(text));
}

TEST(Domains, HaveACrossBetweenTwoNumbers) {
    Domain domain;
    read_domain("domain", "2.5X1", domain);
    EXPECT_EQ(domain, (Domain{2.5, 1}));
    for (const std::string text : {"1", "1x1x1", "0,0,0+1x1x1", "axb", "", "x", "1x"})
        EXPECT_EQ(refused_of([&] { read_domain("domain", text, domain); }),
                  "domain " + shown(text));
}

TEST(Domains, MayHaveACornerBeforeAPlus) {
    const auto domain_of = [](const std::string& text) {
        Domain domain{9, 9, Boundary::torus, 9, 9};
        read_domain("domain", text, domain);
        return domain;
    };
    const auto expected = [](double x0, double y0, double width, double height) {
        return Domain{width, height, Boundary::torus, x0, y0};
    };
    EXPECT_EQ(domain_of("448000,5411000+2000x1500"), expected(448000, 5411000, 2000, 1500));
    EXPECT_EQ(domain_of("-10,-20.5+5X5"), expected(-10, -20.5, 5, 5));
    EXPECT_EQ(domain_of("1e+5,-2e+6+3e+2x4e2"), expected(1e5, -2e6, 300, 400));
    EXPECT_EQ(domain_of("2x1"), expected(0, 0, 2, 1));
    for (const std::string text :
         {"1,2+3", "1,2,3+4x5", "1+2+3x4", "1,2", "1,2x3", ",2+3x4", "1,+3x4", "1,2+x4", "1,2+3x",
          "1,2e+3x4", "1,2++3x4", "1, 2+3x4", "1,2 +3x4", "1,2+3x4+5", "+", ",", ",+x", "e+,e+x"})
        EXPECT_EQ(refused_of([&] { domain_of(text); }), "domain " + shown(text));
}

TEST(Lengths, HaveAUnit) {
    EXPECT_EQ(read_length("margin", "0.5mm", 0), 0.5);
    EXPECT_EQ(read_length("margin", "+2cm", 0), 20);
    EXPECT_EQ(read_length("margin", "1in", 0), 25.4);
    EXPECT_EQ(read_length("margin", "72pt", 0), 25.4);
    for (const char* const text : {"3", "mm", "3km", "1 mm", "--1mm", "-1mm", "201in", "nanmm"})
        EXPECT_EQ(refused_of([&] { read_length("margin", text, 0); }), "margin " + shown(text));
}

TEST(Pens, AreOneDiameterOrTwoOrNone) {
    EXPECT_EQ(read_pens("dot-size", "0.5mm", false), (Pens{0.5, 0.5}));
    EXPECT_EQ(read_pens("dot-size", "0.5mm..1cm", true), (Pens{0.5, 10}));
    EXPECT_EQ(read_pens("dot-size", "radius", true), std::nullopt);
    EXPECT_NE(refused_of([] { read_pens("dot-size", "1mm..2mm", false); }), "accepted");
}

TEST(Papers, AreASizeOrANameThatMayTurn) {
    const Paper given = read_paper("paper-size", "210x297mm");
    EXPECT_EQ(given.width_mm, 210);
    EXPECT_EQ(given.height_mm, 297);
    EXPECT_FALSE(given.may_turn);
    const Paper named = read_paper("paper-size", "LETTER");
    EXPECT_EQ(named.width_mm, 215.9);
    EXPECT_EQ(named.height_mm, 279.4);
    EXPECT_TRUE(named.may_turn);
    for (const std::string text :
         {"A9", "20mm", "20x30", "axbmm", "", "0x20mm", "10x201in", "infx20mm"})
        EXPECT_EQ(refused_of([&] { read_paper("paper-size", text); }), "paper-size " + shown(text));
}

// The values of a line of text, after they were read into the library's options.
StippleOptions options_of(CommandLine& line) {
    StippleOptions options;
    line.sort();
    read(line, targets_of(options));
    return options;
}

TEST(ALine, IsReadIntoTheMembersOfItsOptions) {
    CommandLine line{kStipple,
                     {{"relax", {"3"}},
                      {"IMAGE", {"-a b.png"}},
                      {"torus", {}},
                      {"inks", {"red,#0000ff"}},
                      {"ink-counts", {"70,1k"}},
                      {"sharpen", {"8:2"}},
                      {"gamma", {"1.5"}},
                      {"seed", {"20,000"}}}};
    const StippleOptions options = options_of(line);
    EXPECT_EQ(options.relax, 3U);
    EXPECT_EQ(options.request.domain.boundary, Boundary::torus);
    EXPECT_EQ(options.request.seed, 20000U);
    EXPECT_EQ(options.inks.size(), 2U);
    EXPECT_EQ(options.ink_counts, (std::vector<std::uint64_t>{70, 1000}));
    EXPECT_EQ(options.tone.sharpen, 8U);
    EXPECT_EQ(options.tone.sharpen_amount, 2);
    EXPECT_EQ(options.tone.gamma, 1.5);
    EXPECT_EQ(line.text(0),
              "lacuna stipple './-a b.png' --sharpen 8:2 --gamma 1.5 --inks 'red,#0000ff' "
              "--ink-counts 70,1k --torus --seed 20,000 --relax 3");
}

TEST(GivenOptions, AreThoseWhoseValuesAreNotTheUsual) {
    Request request{.domain = {.boundary = Boundary::torus}, .radius = 0.1, .seed = 7};
    Request usual;
    std::string text;
    for (const GivenOption& one : given_in(kSample, targets_of(request), targets_of(usual)))
        text += std::string(one.name) + (one.values.empty() ? "" : "=" + one.values.front()) + " ";
    EXPECT_EQ(text, "radius=0.1 torus seed=7 ");
}

TEST(ADescription, HasWhatDecidesTheSetInTheOrderOfReports) {
    Request request{.domain = {.width = 2}, .radius = 0.1, .limit = 9};
    Result result;
    result.lines_per_radius = 6;
    const auto names_in = [&] {
        std::string names;
        for (const auto& [name, value] : describe(request, result)) names += name + " ";
        return names;
    };
    EXPECT_EQ(names_in(),
              "width height boundary mode radius count lines_per_radius snap uniform_x limit "
              "round_size seed ");
    EXPECT_EQ(describe(request, result).front().second, Value(2.0));
    request.progressive = true;
    request.radius.reset();
    result.scale = 0.1;
    EXPECT_EQ(names_in(),
              "width height boundary mode metric scale count lines_per_radius progressive snap "
              "uniform_x limit round_size seed ");
    request = {.count = 5, .mode = Mode::stratified};
    EXPECT_EQ(names_in(), "width height boundary mode count seed ");
}

}  // namespace
}  // namespace lacuna::options
