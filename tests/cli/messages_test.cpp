// Messages name the option that was given, as it was given, and what was meant by a misprint.
#include <gtest/gtest.h>

#include <string>

#include "cli/expectations.h"
#include "cli/refusals.h"
#include "program.h"

namespace messages_test {

using namespace lacuna::tests;

TEST(Refused, AreNamedAsTheyWereGiven) {
    std::string grid = "x,y\n";
    for (int i = 0; i < 20; ++i)
        grid += "0." + std::to_string(10 + 4 * i) + "," + (i % 2 == 0 ? "0.2" : "0.7") + "\n";
    expect_refusals(
        {{"grid.csv", grid},
         {"one.txt", "0.5 0.5\n"},
         {"a.foo", ""},
         {"far.csv", "x,y\n1e300,0.5\n"}},
        "",
        {{"sample --count 5 --keep grid.csv", 2, {"--count 5: ", "at least 20", "kept points"}},
         {"stipple raccoon.png --inks cmyk --relax 0 -o a.svg", 2, {"--relax 0: ", "for inks"}},
         {"sample --class a:1e-300 --class b:2e-300 -o a.csv",
          2,
          {"--class a: ", "least distance", "2e-300", "2^20"}},
         {"sample --radius 1e-300", 2, {"--radius 1e-300: must be at least 9.5"}},
         {"relax one.txt raccoon.png --along 3", 2, {"--along: no such option"}},
         {"order one.txt raccoon.png --along 3", 2, {"--along: no such option"}},
         {"sample --radius .1 --outside a.foo", 2, {"--outside a.foo: must end in .svg"}},
         {"sample --radius .1 --inside a.foo", 2, {"--inside a.foo: must end in .svg"}},
         {"sample --radius .1 --avoid far.csv:.1", 3, {"far.csv:2: (1e+300, 0.5): "}}});
}

TEST(AnSvgOfOurs, GivenAsAPictureIsCalledByItsName) {
    const Folder folder;
    expect_success({"sample", "--radius", ".2", "--quiet", "-o", folder.path("own.svg")});
    expect_refusals(folder, "",
                    {{"stipple own.svg -o a.svg", 3, {"own.svg: an SVG picture: "}},
                     {"sample --field own.svg --scale .1", 3, {"own.svg: an SVG"}}});
}

TEST(Misprints, AreAnsweredWithTheOptionThatWasMeant) {
    expect_refusals(Files{}, "sample",
                    {{"--radis 0.1", 2, {"--radis: ", "did you mean --radius?"}},
                     {"--RADIUS 0.1", 2, {"--RADIUS: ", "did you mean --radius?"}},
                     {"--dot 1mm", 2, {"--dot: ", "did you mean --dot-size"}},
                     {"--lines=3", 2, {"--lines=3: ", "did you mean --lines-per-radius?"}}});
}

}  // namespace messages_test
