// The command lines that are refused for their options, with exit code and message. Those that are
// refused for their files are in refused_files_test.cpp.
#include <gtest/gtest.h>

#include <string>

#include "cli/refusals.h"

namespace {

using namespace lacuna::tests;

TEST(Refused, OfSampleIsABadRadius) {
    const Refusals refusals{
        {"--radius 0", 2, "--radius 0:", "greater than 0"},
        {"--radius ''", 2, "--radius \"\":", "must be a number"},
        {"--radius=", 2, "--radius: a value must follow"},
        {"--radius", 2, "--radius: a value must follow"},
        {"--radius '1\n2'", 2, "--radius \"1\\n2\":", "must be a number"},
        {"--radius 1.5", 2, "--radius 1.5:", "at most 1.41421"},
        {"--radius 1e-6", 2, "--radius 1e-06:", "needs about", "GB"},
        {"--radius 0.1 --radius 0.2", 2, "--radius: must be given only once"},
    };
    expect_refusals(Files{}, "sample -o a.txt", refusals);
}

TEST(Refused, OfSampleIsABadCount) {
    const Refusals refusals{
        {"--count 0", 2, "--count 0:", "at least 1"},
        {"--count 1000000000000", 2, "--count 1000000000000:", "GB"},
        {"--count 10 --radius 0.1", 2, "--radius 0.1:", "either a radius or a count"},
        {"", 2, "--radius missing:", "either a radius or a count"},
        {"--count 5 --start stratified", 2, "--mode stratified:", "is a start for --relax"},
        {"--count 5 --gaussian --gaussian-distance 2", 2, "--gaussian-distance 2:", "0 and 1"},
        {"--count 5 --gaussian --progressive", 2,
         "lacuna: --gaussian 150 with --progressive: it moves the points\n"},
        {"--count 5 --gaussian --field raccoon.png", 2, "--gaussian 150:", "without a picture"},
    };
    expect_refusals(Files{}, "sample -o a.txt", refusals);
}

TEST(Refused, OfSampleIsABadDomain) {
    const Refusals refusals{
        {"--domain 0x1", 2, "--domain 0x1:", "greater than 0"},
        {"--domain 1", 2, "--domain 1:", "WIDTHxHEIGHT"},
        {"--domain 1,2+3", 2, "--domain 1,2+3:", "X0,Y0+WIDTHxHEIGHT"},
        {"--domain 1,2,3+4x5", 2, "--domain 1,2,3+4x5:", "X0,Y0+WIDTHxHEIGHT"},
        {"--domain nan,0+1x1", 2, "--domain nan,0+1x1:", "finite numbers"},
        {"--domain 0,-inf+1x1", 2, "--domain 0,-inf+1x1:", "finite numbers"},
        {"--domain 1e9,0+1x1", 2, "--domain 1e+09,0+1x1:", "at most 1048576 from 0"},
        {"--domain 1,2+-3x1", 2, "--domain 1,2+-3x1:", "greater than 0"},
    };
    expect_refusals(Files{}, "sample -o a.txt --radius 0.1", refusals);
}

TEST(Refused, OfSampleAreBadOptions) {
    const Refusals refusals{
        {"--mode dots", 2, "--mode dots:", "must be exact, lines or stratified"},
        {"--snap", 2, "--snap with mode exact:", "for mode lines only"},
        {"--lines-per-radius 0", 2, "--lines-per-radius 0:", "between 1 and"},
        {"--threads 100000", 2, "--threads 100000: must be at most 1024"},
        {"--mode lines --uniform-x --round-size 5", 2, "--round-size 5:", "must be 1"},
        {"--backend abacus", 2, "--backend abacus:", "must be one of auto"},
        {"--backend 'a\x1b[2Jb\n\xc2\x9b'", 2, "--backend a\\x1b[2Jb\\n\\x9b:"},
        {"--torus=no", 2, "--torus: takes no value"},
        {"--colour red", 2, "--colour", "no such option", "lacuna sample --help"},
        {"-z", 2, "-z", "no such option"},
        {"image.png", 2, "image.png:", "no arguments are taken"},
        {"raccoon.png", 2, "raccoon.png", "no arguments are taken"},
        {"--report report.txt", 2, "--report report.txt:", ".json"},
        {"--metric min", 2, "--metric", "no such option"},
        {"--pen-path", 2, "--pen-path", "no such option"},
        {"--border 0.5", 2,
         "lacuna: --border 0.5: must be at least 0 and under half of the domain's shorter side, "
         "0.5\n"},
        {"--invert", 2,
         "lacuna: --invert without --field: says how a field is read: give its picture too\n"},
    };
    expect_refusals(Files{}, "sample -o a.svg --radius 0.1", refusals);
}

TEST(Refused, OfSampleAreOutputsOfUnknownFormats) {
    const Refusals refusals{
        {"-o points.xyz", 2, "--output points.xyz:", "svg"},
        {"-o points", 2, "--output points:", "svg"},
        {"-o points.txt.gz", 2, "--output points.txt.gz:", "svg"},
        {"-o a.svg --format csv", 2, "--format csv:", "a.svg"},
        {"--format dat", 2, "--format dat:", "must be one of .txt .csv"},
        {"--dot-size 3mm", 2, "--dot-size with --output -:", "not for .txt"},
    };
    expect_refusals(Files{}, "sample --radius 0.1", refusals);
}

TEST(Refused, OfSampleAreSeedsThatAreUnclear) {
    const Refusals refusals{
        {"--seeds 5 -o {seed}.npy", 2, "seeds 5"},
        {"--seeds 5.. -o {seed}.npy", 2, "seeds"},
        {"--seeds 5..4 -o {seed}.npy", 2, "seeds 5..4"},
        {"--seeds -1..4 -o {seed}.npy", 2, "seeds"},
        {"--seeds 0..1000000 -o {seed}.npy", 2, "1000000"},
        {"--seeds 0..3", 2, "{seed}"},
        {"--seeds 0..3 -o a.npy", 2, "{seed}"},
        {"--seeds 0..3 -o {seed}.npy -o -", 2, "{seed}"},
        {"--seeds 0..3 --seed 4 -o {seed}.npy", 2, "--seed"},
        {"--seeds 0..3 --relax 4 -o {seed}.npy", 2, "relax 4"},
        {"--seeds 0..3 --gaussian -o {seed}.npy", 2, "gaussian 150"},
        {"--seeds 0..3 -o {seed}.doc", 2, "0.doc"},
        {"--seeds 0..3 -o {seed}.npy --report {seed}.json", 2, "one report of all sets"},
        {"--seeds 0..3 -o none/{seed}.npy", 3, "none"},
    };
    expect_refusals(Files{}, "sample --radius 0.1", refusals);
}

TEST(Refused, OfStippleAreBadOptions) {
    const Refusals refusals{
        {"--count 9 --scale 1", 2, "--scale 1:", "either"},
        {"--count 0", 2, "--count 0:", "at least 1"},
        {"--count 1000000000", 2, "--count 1000000000:", "GB"},
        {"--count 9 --radius 0.1", 2, "--radius", "no such option"},
        {"--count 9 --metric most", 2, "--metric most:", "min, mean"},
        {"--mode lines", 2, "--mode lines:", "must be stratified, cells or exact"},
        {"--count 9 --black 1", 2, "--black 1:", "under 1"},
        {"--count 9 --sharpen 2:", 2, "--sharpen", "must be a number"},
        {"-c 9", 2, "did you mean --count?"},
        {"raccoon.png --count 10", 2, "raccoon.png", "no more arguments"},
        {"dots.svg", 2, "dots.svg: no more arguments are taken, did you mean -o dots.svg?"},
        {"raccoon.png", 2,
         "raccoon.png: no more arguments are taken: one picture is stippled, or "
         "several with --frames 'PATTERN', in quotes; see"},
        {"--paper A4", 2, "did you mean --paper-colour or --paper-size?"},
        {"--time 2h", 2, "did you mean --plot-time?"},
        {"--count 10.000", 2, "--count 10.000: must be a whole number, such as 20000, 20,000 or"},
    };
    expect_refusals(Files{}, "stipple raccoon.png -o a.svg", refusals);
}

TEST(Refused, OfStippleAreDrawingsThatCannotBe) {
    const Refusals refusals{
        {"-o a.svg --dot-size 3", 2, "--dot-size 3:", "mm, cm, in or pt"},
        {"-o a.svg --paper-size A9", 2, "--paper-size A9:", "A0 to A6", "210x297mm"},
        {"-o a.svg --margin 1cm --paper-size 20x50mm", 2, "--margin 10mm:", "less than half",
         "20mm"},
        {"-o a.svg --dpi 300", 2, "--dpi with --output ", "a.svg: is for .png"},
        {"-o a.png --dpi 0", 2, "--dpi 0:", "over 0"},
        {"-o a.png --dpi 5000", 2, "--dpi 5000:", "at most 4607", "32767"},
        {"--dot-size 1mm", 2, "--dot-size with --output -:"},
        {"--dot-size radius", 2, "--dot-size with --output -:"},
        {"--paper-size A4", 2, "--paper-size with --output -:"},
        {"--dpi 100", 2, "--dpi with --output -:"},
    };
    expect_refusals(Files{}, "stipple raccoon.png --count 10", refusals);
}

TEST(Refused, OfAnalyzeAreBadOptions) {
    std::string points;
    for (int i = 0; i < 3000; ++i) points += std::to_string(i / 3000.0) + " 0.5\n";
    const Refusals refusals{
        {"--max-frequency 0", 2, "max-frequency", "0"},
        {"--max-frequency 1000", 2, "max-frequency 1000", "3000 points", "2^31"},
        {"--threads 1025", 2, "threads 1025", "1024"},
        {"-o a.xyz", 2, "--output a.xyz: ", ".json .svg .pdf .png"},
        {"-o b.txt", 2, ".json .svg .pdf .png"},
        {"-o - --format txt", 2, "--format txt: ", ".json .svg .pdf .png"},
        {"-o", 2, "--output", "a value must follow"},
        {"--radius 0", 2, "--radius 0:", "greater than 0"},
        {"--wrong", 2, "--wrong", "no such option"},
    };
    expect_refusals({{"a.txt", points}}, "analyze a.txt", refusals);
}

TEST(Refused, OfVerifyAreBadOptions) {
    const Refusals refusals{
        {"", 2, "--radius missing"},
        {"--radius 0", 2, "--radius 0:", "greater than 0"},
        {"--field raccoon.png", 2, "--scale missing"},
        {"--radius 1 --border 1 --torus", 2, "--border 1", "torus"},
    };
    expect_refusals({{"a.txt", "0.25 0.25\n"}}, "verify a.txt", refusals);
}

TEST(Refused, OfCompareAreBadOptions) {
    const Refusals refusals{
        {"--radius 0.1 --runs 0", 2, "--runs 0", "between 1 and"},
        {"--radius 0.1 --backends gpu", 2, "--backends", "gpu", "cpu, opencl, vulkan or reference"},
        {"--radius 0.1 --output a.txt", 2, "--output", ".svg .pdf .png"},
        {"--radius 0.1 --json a.txt", 2, "--json", ".json"},
        {"--count 10 --mode stratified", 2, "--mode stratified:", "is a start for --relax"},
        {"raccoon.png --count 10 --along 3 --relax 2", 2, "--along 3 with --relax: "},
        {"", 2, "--radius", "missing"},
    };
    expect_refusals(Files{}, "compare", refusals);
}

TEST(Refused, OfReproduceAreBadOptions) {
    const Refusals refusals{
        {"", 2, "WHAT", "lacuna reproduce --help"},
        {"fig9", 2, "fig9: must be table1, table2, fig3, ", "fig8 or all"},
        {"fig3 --runs 0", 2, "--runs 0: ", "at least 1"},
        {"fig3 --runs x", 2, "--runs x: "},
        {"table1 --smallest-radius 0.1", 2, "--smallest-radius 0.1: ", "0.05"},
        {"fig3 --wrong", 2, "--wrong", "no such option"},
        {"fig7", 2, "--image missing: fig7 stipples a picture", "--image FILE"},
        {"all", 2, "--image missing: fig7 stipples a picture", "--image FILE"},
    };
    expect_refusals(Files{}, "reproduce", refusals);
}

TEST(Refused, AreWordsThatAreMisspeltMissingOrTooMany) {
    const Refusals refusals{
        {"", 2, "lacuna --help"},
        {"--radius 0.1", 2, "lacuna --help"},
        {"smaple", 2, "smaple: no such command", "did you mean sample?", "lacuna --help"},
        {"help sampel", 2, "sampel: no such command, did you mean sample?"},
        {"sample --raduis 0.1", 2, "--raduis", "did you mean --radius?"},
        {"stipple a.png --papersize=A4", 2, "did you mean --paper-size?"},
        {"sample help", 2, "help: no arguments are taken, did you mean --help?"},
        {"sample 0.1", 2, "0.1: no arguments are taken; see"},
        {"sample -r 0.1", 2,
         "-r: no such option, and no arguments are taken, did you mean --radius?"},
        // A word that the help of an option has.
        {"stipple a.png --strokes 3", 2, "--strokes: no such option", "see --along;"},
        {"stipple a.png ------", 2, "------: no such option"},
        {"stipple --count 9", 2, "IMAGE is required (- is standard input)",
         "lacuna stipple --help"},
        {"analyze", 2, "FILE", "lacuna analyze --help"},
        {"verify --radius 1", 2, "FILE", "lacuna verify --help"},
        // Reported before any file is opened.
        {"analyze missing.txt --radius -1", 2, "--radius -1:"},
        {"verify missing.txt --radius -1", 2, "--radius -1:"},
    };
    expect_refusals(Files{}, "", refusals);
}

}  // namespace
