// Given a request that cannot be met, the program says so in one line and touches nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "program.h"

namespace {

using namespace lacuna::test;

struct BadUsage {
    std::string name;
    std::vector<std::string> arguments;  // after `sample -o FILE`
    std::vector<std::string> told;       // what the line must hold: option, value, what is allowed
};

std::ostream& operator<<(std::ostream& out, const BadUsage& bad) {
    return out << bad.name;
}

class ABadUsage : public testing::TestWithParam<BadUsage> {};

TEST_P(ABadUsage, ExitsWith2AndOneLineAndNoFile) {
    const Folder folder;
    std::vector<std::string> arguments{"sample", "-o", folder.path("points.txt")};
    arguments.insert(arguments.end(), GetParam().arguments.begin(), GetParam().arguments.end());

    const Outcome outcome = run(arguments);

    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.starts_with("lacuna: ")) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_TRUE(outcome.err.ends_with('\n')) << outcome.err;
    for (const std::string& told : GetParam().told)
        EXPECT_NE(outcome.err.find(told), std::string::npos) << told << " in: " << outcome.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

std::string name_of_case(const testing::TestParamInfo<BadUsage>& info) {
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Radius, ABadUsage,
    testing::Values(
        BadUsage{"Zero", {"--radius", "0"}, {"--radius 0:", "greater than 0"}},
        BadUsage{"Negative", {"--radius", "-1"}, {"--radius -1:", "greater than 0"}},
        BadUsage{"NotANumber", {"--radius", "nan"}, {"--radius nan:", "finite"}},
        BadUsage{"Infinite", {"--radius", "inf"}, {"--radius inf:", "finite"}},
        BadUsage{"Empty", {"--radius", ""}, {"--radius \"\":", "must be a number"}},
        BadUsage{"EmptyAfterEquals", {"--radius="}, {"--radius: a value must follow"}},
        BadUsage{"Missing", {"--radius"}, {"--radius: a value must follow"}},
        BadUsage{"WithAUnit", {"--radius", "5x"}, {"--radius 5x:", "must be a number"}},
        BadUsage{"Hexadecimal", {"--radius", "0x1"}, {"--radius 0x1:", "must be a number"}},
        BadUsage{"WithBlanks", {"--radius", " 0.1"}, {"--radius \" 0.1\":", "must be a number"}},
        BadUsage{
            "WithALineBreak", {"--radius", "1\n2"}, {"--radius \"1\\n2\":", "must be a number"}},
        BadUsage{"OverADouble", {"--radius", "1e400"}, {"--radius 1e400:", "a double can hold"}},
        BadUsage{"OverTheBox", {"--radius", "1.5"}, {"--radius 1.5:", "at most 1.41421"}},
        BadUsage{"OverTheTorus",
                 {"--radius", "1.5", "--torus", "--domain", "2x1"},
                 {"--radius 1.5:", "at most 1,"}},
        BadUsage{"OutOfMemory", {"--radius", "1e-12"}, {"--radius 1e-12:", "needs about", "GB"}},
        BadUsage{"Twice",
                 {"--radius", "0.1", "--radius", "0.2"},
                 {"--radius: must be given only once"}}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Count, ABadUsage,
    testing::Values(BadUsage{"Zero", {"--count", "0"}, {"--count 0:", "at least 1"}},
                    BadUsage{
                        "TooLarge", {"--count", "1000000000000"}, {"--count 1000000000000:", "GB"}},
                    BadUsage{"Negative", {"--count", "-3"}, {"--count -3:", "whole number"}},
                    BadUsage{"Fraction", {"--count", "1.5"}, {"--count 1.5:", "whole number"}},
                    BadUsage{"Over64Bits",
                             {"--count", "18446744073709551616"},
                             {"--count 18446744073709551616:", "at most 18446744073709551615"}},
                    BadUsage{"AndRadius",
                             {"--count", "10", "--radius", "0.1"},
                             {"--radius 0.1:", "either a radius or a count"}},
                    BadUsage{"NorRadius", {}, {"--radius missing:", "either a radius or a count"}}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Domain, ABadUsage,
    testing::Values(
        BadUsage{"ZeroWide",
                 {"--radius", "0.1", "--domain", "0x1"},
                 {"--domain 0x1:", "greater than 0"}},
        BadUsage{"ZeroHigh",
                 {"--radius", "0.1", "--domain", "1x0"},
                 {"--domain 1x0:", "greater than 0"}},
        BadUsage{
            "Infinite", {"--radius", "0.1", "--domain", "1xinf"}, {"--domain 1xinf:", "finite"}},
        BadUsage{"TooThin",
                 {"--radius", "0.1", "--domain", "1x1000000"},
                 {"--domain 1x", "at most 1000 times"}},
        BadUsage{"OneSide", {"--radius", "0.1", "--domain", "1"}, {"--domain 1:", "WIDTHxHEIGHT"}},
        BadUsage{"ThreeSides",
                 {"--radius", "0.1", "--domain", "1x1x1"},
                 {"--domain 1x1x1:", "WIDTHxHEIGHT"}},
        BadUsage{
            "Words", {"--radius", "0.1", "--domain", "axb"}, {"--domain axb:", "WIDTHxHEIGHT"}},
        BadUsage{"Empty", {"--radius", "0.1", "--domain", ""}, {"--domain \"\":", "WIDTHxHEIGHT"}}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Rest, ABadUsage,
    testing::Values(
        BadUsage{"UnknownMode",
                 {"--radius", "0.1", "--mode", "dots"},
                 {"--mode dots:", "must be exact or lines"}},
        BadUsage{"SnapInExact",
                 {"--radius", "0.1", "--snap"},
                 {"--snap with mode exact:", "for mode lines only"}},
        BadUsage{"UniformXInExact",
                 {"--radius", "0.1", "--mode", "exact", "--uniform-x"},
                 {"--uniform-x with mode exact:", "for mode lines only"}},
        BadUsage{"NoLines",
                 {"--radius", "0.1", "--lines-per-radius", "0"},
                 {"--lines-per-radius 0:", "between 1 and"}},
        BadUsage{"LinesOver32Bits",
                 {"--radius", "0.1", "--lines-per-radius", "4294967296"},
                 {"--lines-per-radius 4294967296:", "at most 4294967295"}},
        BadUsage{"NoPoints", {"--radius", "0.1", "--limit", "0"}, {"--limit 0:", "at least 1"}},
        BadUsage{"NegativeSeed", {"--radius", "0.1", "--seed", "-1"}, {"--seed -1:", "whole"}},
        BadUsage{"NegativeThreads",
                 {"--radius", "0.1", "--threads", "-1"},
                 {"--threads -1:", "whole number"}},
        BadUsage{"RoundsOfUniformX",
                 {"--radius", "0.1", "--mode", "lines", "--uniform-x", "--round-size", "5"},
                 {"--round-size 5:", "must be 1"}},
        BadUsage{"UnknownBackend",
                 {"--radius", "0.1", "--backend", "abacus"},
                 {"--backend abacus:", "must be one of auto"}},
        BadUsage{"ABackendThatWouldClearTheScreen",
                 {"--radius", "0.1", "--backend", "a\x1b[2Jb\n\xc2\x9b"},
                 {"--backend a\\x1b[2Jb\\n\\x9b:"}},
        BadUsage{"FlagWithAValue", {"--radius", "0.1", "--torus=no"}, {"--torus: takes no value"}},
        BadUsage{"UnknownOption",
                 {"--radius", "0.1", "--colour", "red"},
                 {"--colour", "no such option", "lacuna sample --help"}},
        BadUsage{"UnknownShortOption", {"--radius", "0.1", "-z"}, {"-z", "no such option"}},
        BadUsage{"StrayArgument",
                 {"--radius", "0.1", "image.png"},
                 {"image.png:", "no arguments are taken"}},
        BadUsage{"ReportExtension",
                 {"--radius", "0.1", "--report", "report.txt"},
                 {"--report report.txt:", ".json"}}),
    name_of_case);

TEST(AnOutput, OfAnUnknownExtensionIsRefusedAndTheKnownOnesAreNamed) {
    const Folder folder;
    for (const std::string name : {"points.xyz", "points", "points.txt.gz"}) {
        const Outcome outcome = run({"sample", "--radius", "0.1", "-o", folder.path(name)});
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_NE(outcome.err.find("--output " + folder.path(name) + ":"), std::string::npos);
        EXPECT_NE(outcome.err.find("svg"), std::string::npos) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

TEST(AReport, MayNotBeTheOutput) {
    const Folder folder;
    const std::string path = folder.path("a.json");
    const std::string same = folder.path("./a.json");
    const Outcome outcome = run({"sample", "--radius", "0.1", "-o", path, "--report", same});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("--report " + same + ": must be another file"), std::string::npos)
        << outcome.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

TEST(TheProgram, WithoutACommandOrWithAnUnknownOneSaysHowToGetHelp) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{}, {"smaple"}, {"--radius", "0.1"}}) {
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_NE(outcome.err.find("lacuna --help"), std::string::npos) << outcome.err;
    }
}

}  // namespace
