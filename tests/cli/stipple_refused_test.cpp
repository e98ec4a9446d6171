// Given a picture or options that cannot be stippled, one line says so and nothing is written.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ostream>
#include <string>
#include <vector>

#include "cli/pictures.h"
#include "program.h"

namespace {

using namespace lacuna::test;
using Names = std::vector<std::string>;

void expect_refusal(const Outcome& outcome, int exit_code, const Names& told) {
    EXPECT_EQ(outcome.exit_code, exit_code);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.starts_with("lacuna: ")) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_TRUE(outcome.err.ends_with('\n')) << outcome.err;
    for (const std::string& part : told)
        EXPECT_NE(outcome.err.find(part), std::string::npos) << part << " in: " << outcome.err;
}

struct BadPicture {
    std::string name;
    std::string content;
    Names told;
};

std::ostream& operator<<(std::ostream& out, const BadPicture& bad) {
    return out << bad.name;
}

// NumPy's format, one row.
std::string npy(const std::vector<double>& values) {
    const std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (1, " +
                               std::to_string(values.size()) + "), }\n";
    std::string file("\x93NUMPY\1\0", 8);
    file += static_cast<char>(header.size());
    file += '\0';
    file += header;
    std::string numbers(values.size() * sizeof(double), '\0');
    std::memcpy(numbers.data(), values.data(), numbers.size());
    return file + numbers;
}

std::string half_of_the_raccoon() {
    const std::string whole = content_of(kRaccoon);
    return whole.substr(0, whole.size() / 2);
}

class ABadPicture : public testing::TestWithParam<BadPicture> {};

TEST_P(ABadPicture, ExitsWith3AndOneLineAndNoFile) {
    const Folder folder;
    const std::string image = folder.path("image.png");
    write_file(image, GetParam().content);
    const Outcome outcome = run({"stipple", image, "--count", "100", "-o", folder.path("a.svg"),
                                 "--report", folder.path("a.json")});
    expect_refusal(outcome, 3, GetParam().told);
    EXPECT_NE(outcome.err.find(image), std::string::npos) << outcome.err;
    EXPECT_EQ(folder.names(), Names{"image.png"});
}

INSTANTIATE_TEST_SUITE_P(
    Picture, ABadPicture,
    testing::Values(BadPicture{"Text", "hello\n", {"begins with \"hello", "must be a picture"}},
                    BadPicture{"Empty", "", {"empty"}},
                    BadPicture{"Truncated", half_of_the_raccoon(), {"not a whole PNG"}},
                    BadPicture{"White", pgm(2, 1, bytes({255, 255})), {"white all over"}},
                    BadPicture{"NoPixels", pgm(0, 0, ""), {"0 x 0 pixels", "at least 1 x 1"}},
                    BadPicture{"TooLong",
                               pgm(100000, 1, std::string(100000, '\0')),
                               {"100000 x 1 pixels", "at most 1000 times"}},
                    BadPicture{"Nan", npy({0, std::nan("")}), {"column 1", "nan", "finite"}},
                    BadPicture{"Negative", npy({0.5, -1}), {"column 1", "-1", "0 or more"}}),
    [](const testing::TestParamInfo<BadPicture>& bad) { return bad.param.name; });

TEST(AMissingPicture, ExitsWith3AndNamesIt) {
    const Folder folder;
    const std::string image = folder.path("none.png");
    expect_refusal(run({"stipple", image, "--count", "100", "-o", folder.path("a.svg")}), 3,
                   {image, "No such file"});
    EXPECT_EQ(folder.names(), Names{});
}

struct BadOption {
    std::string name;
    Names arguments;  // after `stipple raccoon.png -o a.svg`
    Names told;
};

std::ostream& operator<<(std::ostream& out, const BadOption& bad) {
    return out << bad.name;
}

class ABadOptionOfStipple : public testing::TestWithParam<BadOption> {};

TEST_P(ABadOptionOfStipple, ExitsWith2AndOneLineAndNoFile) {
    const Folder folder;
    Names arguments{"stipple", kRaccoon, "-o", folder.path("a.svg")};
    const Names& more = GetParam().arguments;
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_refusal(run(arguments), 2, GetParam().told);
    EXPECT_EQ(folder.names(), Names{});
}

std::string name_of_option(const testing::TestParamInfo<BadOption>& info) {
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Size, ABadOptionOfStipple,
    testing::Values(
        BadOption{"Both", {"--count", "9", "--scale", "1"}, {"--scale 1:", "either"}},
        BadOption{"NoDots", {"--count", "0"}, {"--count 0:", "at least 1"}},
        BadOption{"ScaleOfZero", {"--scale", "0"}, {"--scale 0:", "greater than 0"}},
        BadOption{"ScaleNotANumber", {"--scale", "nan"}, {"--scale nan:", "finite"}},
        BadOption{"MoreDotsThanCells",
                  {"--count", "1000000000"},
                  {"--count 1000000000:", "steps long, of at most 131072", "fewer points"}},
        BadOption{"AScaleFinerThanCells",
                  {"--scale", "1e-9"},
                  {"--scale 1e-09:", "steps long, of at most 131072", "larger scale"}},
        BadOption{"Radius", {"--count", "9", "--radius", "0.1"}, {"--radius", "no such option"}}),
    name_of_option);

INSTANTIATE_TEST_SUITE_P(
    Importance, ABadOptionOfStipple,
    testing::Values(
        BadOption{"Metric", {"--count", "9", "--metric", "most"}, {"--metric most:", "min, mean"}},
        BadOption{"Mode", {"--mode", "lines"}, {"--mode lines:", "must be cells or exact"}},
        BadOption{"MetricOfExact",
                  {"--count", "9", "--mode", "exact", "--metric", "mean"},
                  {"--metric mean:", "is for mode cells"}},
        BadOption{"Black", {"--count", "9", "--black", "1"}, {"--black 1:", "under 1"}},
        BadOption{"White",
                  {"--count", "9", "--black", "0.5", "--white", "0.4"},
                  {"--white 0.4:", "over --black, 0.5"}},
        BadOption{"Gamma", {"--count", "9", "--gamma", "0"}, {"--gamma 0:", "over 0"}},
        BadOption{
            "Least", {"--count", "9", "--min-importance", "2"}, {"--min-importance 2:", "0 to 1"}},
        BadOption{"NoLines",
                  {"--count", "9", "--lines-per-radius", "0"},
                  {"--lines-per-radius 0:", "between 1 and 1000"}}),
    name_of_option);

INSTANTIATE_TEST_SUITE_P(
    Drawing, ABadOptionOfStipple,
    testing::Values(
        BadOption{"DotWithoutUnit", {"--dot-size", "3"}, {"--dot-size 3:", "mm, cm, in or pt"}},
        BadOption{"NoDot", {"--dot-size", "0mm"}, {"--dot-size 0mm:", "0.001mm to 200in"}},
        BadOption{"Paper", {"--paper-size", "A9"}, {"--paper-size A9:", "A0 to A6", "210x297mm"}},
        BadOption{"OneSide", {"--paper-size", "20mm"}, {"--paper-size 20mm:", "WIDTHxHEIGHT"}},
        BadOption{"NoWidth", {"--paper-size", "0x20mm"}, {"--paper-size 0x20mm:", "1mm to 200in"}},
        BadOption{"TooLarge", {"--paper-size", "10x201in"}, {"10x201in:", "1mm to 200in"}},
        BadOption{"Infinite", {"--paper-size", "infx20mm"}, {"infx20mm:", "1mm to 200in"}},
        BadOption{"MarginAlone", {"--margin", "1cm"}, {"--margin 10mm:", "--paper-size"}},
        BadOption{"MarginOfAll",
                  {"--margin", "1cm", "--paper-size", "20x50mm"},
                  {"--margin 10mm:", "less than half", "20mm"}},
        BadOption{"DpiOfNoPng", {"--dpi", "300"}, {"--dpi with --output ", "a.svg: is for .png"}}),
    name_of_option);

TEST(PixelsAnInch, AreOver0AndNoMoreThanAPngHasRoomFor) {
    const Folder folder;
    const auto stipple = [&](const std::string& dpi) {
        return run(
            {"stipple", kRaccoon, "--count", "10", "-o", folder.path("a.png"), "--dpi", dpi});
    };
    expect_refusal(stipple("0"), 2, {"--dpi 0:", "over 0"});
    expect_refusal(stipple("5000"), 2, {"--dpi 5000:", "at most 4607", "32767"});
    EXPECT_EQ(folder.names(), Names{});
}

TEST(DrawingOptions, WithoutAPictureToDrawAreRefused) {
    for (const Names& option : {Names{"--dot-size", "1mm"}, Names{"--dot-size", "radius"},
                                Names{"--paper-size", "A4"}, Names{"--dpi", "100"}}) {
        Names arguments{"stipple", kRaccoon, "--count", "10"};
        arguments.insert(arguments.end(), option.begin(), option.end());
        expect_refusal(run(arguments), 2, {option.front() + " with --output -:"});
    }
}

TEST(AnOutput, ThatIsThePictureIsRefusedAndThePictureStays) {
    const Folder folder;
    const std::string image = folder.path("photo.png");
    write_file(image, content_of(kRaccoon));
    const std::string roundabout = folder.path("./photo.png");
    expect_refusal(run({"stipple", image, "--count", "10", "-o", roundabout}), 2,
                   {"--output " + roundabout + ": must be another file than IMAGE " + image});
    EXPECT_EQ(content_of(image), content_of(kRaccoon));
}

TEST(MemoryBeyondTheMachine, IsRefusedAtOnceWithWhatThereIs) {
    const Folder folder;
    const std::string image = grey_picture(folder, 1, 1, bytes({0}));
    // The most points for lattices of one step to the radius: 320 GB.
    expect_refusal(run({"stipple", image, "--count", "5000000000", "--lines-per-radius", "1", "-o",
                        folder.path("a.svg")}),
                   2, {"--count 5000000000:", "needs about", "GB of memory, more than the"});
    EXPECT_EQ(folder.names(), Names{"picture.pgm"});
}

TEST(ADarkPixel, TooSmallForItsDotsIsRefusedAtOnce) {
    const Folder folder;
    std::string pixels(4000000, '\xff');
    pixels[1234567] = '\0';
    const std::string image = grey_picture(folder, 2000, 2000, pixels);
    expect_refusal(run({"stipple", image, "--count", "1000", "-o", folder.path("a.svg")}), 2,
                   {"--count 1000:", "steps long", "fewer points"});
    EXPECT_EQ(folder.names(), Names{"picture.pgm"});
}

TEST(ASample, RefusesWhatBelongsToStipple) {
    const Folder folder;
    const auto sample = [&](const Names& more) {
        Names arguments{"sample", "-o", folder.path("a.svg"), "--radius", "0.1"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    };
    expect_refusal(sample({"--mode", "cells"}), 2, {"--mode cells:", "lacuna stipple", "exact"});
    expect_refusal(sample({kRaccoon}), 2, {kRaccoon, "no arguments are taken"});
    expect_refusal(sample({"--metric", "min"}), 2, {"--metric", "no such option"});
    expect_refusal(sample({"--pen-path"}), 2, {"--pen-path", "no such option"});
    for (const std::string option : {"--scale", "--gamma", "--min-importance"})
        expect_refusal(sample({option, "1"}), 2, {option + " without --field"});
    expect_refusal(sample({"--invert"}), 2, {"--invert without --field"});
    EXPECT_EQ(folder.names(), Names{});
}

TEST(AStipple, WithoutAnImageSaysHowToGetHelp) {
    expect_refusal(run({"stipple", "--count", "10"}), 2,
                   {"IMAGE is required", "lacuna stipple --help"});
    expect_refusal(run({"stipple", kRaccoon, kRaccoon, "--count", "10"}), 2,
                   {kRaccoon, "no more arguments"});
}

}  // namespace
