// A file is made again by the command that it records.
#include <gtest/gtest.h>

#include <string>

#include "cli/stippling.h"
#include "program.h"

namespace again_test {

using namespace lacuna::tests;

TEST(Again, MakesTheSameFileAndSaysWhenThePictureIsMissingOrAnotherOne) {
    const Folder folder;
    ASSERT_EQ(run_in(folder, "cp " LACUNA_EXAMPLES "/raccoon.png \"it's <a> & b.png\"").exit_code,
              0);
    const std::string program = LACUNA_PROGRAM;
    const auto lacuna = [&](const std::string& words) {
        return run_in(folder, program + " " + words);
    };
    EXPECT_EQ(
        lacuna("stipple \"it's <a> & b.png\" --count 200 --pens 1mm,2mm --quiet -o a.svg -o a.json")
            .exit_code,
        0);
    for (const std::string name : {"a.svg", "a.json"}) {
        EXPECT_EQ(lacuna("again " + name + " --quiet -o b" + name).err, "");
        EXPECT_EQ(content_of(folder.path("b" + name)), content_of(folder.path(name)));
    }
    EXPECT_EQ(lacuna("sample --radius 0.1 --seed 3 --quiet -o c.json").exit_code, 0);
    EXPECT_EQ(lacuna("again c.json --quiet -o d.json").err, "");
    EXPECT_EQ(content_of(folder.path("d.json")), content_of(folder.path("c.json")));

    EXPECT_EQ(lacuna("again c.json a.svg -o e.svg").err,
              "lacuna: IMAGE a.svg: is for files of lacuna stipple\n");
    EXPECT_EQ(run_in(folder, "mv *.png moved.png").exit_code, 0);
    EXPECT_EQ(
        lacuna("again a.svg -o e.svg").err,
        "lacuna: a.svg: there is no picture it's <a> & b.png, of which it was made: give it as "
        "IMAGE, after a.svg\n");
    EXPECT_EQ(lacuna("again a.svg moved.png --quiet -o a.csv").err, "");
    EXPECT_TRUE(lacuna("again a.svg " LACUNA_EXAMPLES "/hopper.jpg -o e.svg")
                    .err.find(": is another picture than a.svg was made of: its SHA-256 is ") !=
                std::string::npos);
    EXPECT_EQ(
        lacuna("again moved.png -o e.svg").err,
        "lacuna: moved.png: records no command: must be an .svg or .json that lacuna has made\n");
    for (const std::string evil :
         {"stipple moved.png --output x", "stipple moved.png -ox", "devices", "again a.svg"}) {
        write_file(folder.path("evil.svg"), "<dc:source>lacuna " + evil + "</dc:source>");
        const Outcome outcome = lacuna("again evil.svg -o e.svg");
        EXPECT_EQ(outcome.exit_code, 3) << evil;
        EXPECT_TRUE(outcome.err.ends_with(", which no file of lacuna does\n")) << outcome.err;
    }
    EXPECT_EQ(run_in(folder, "ls e.svg x").out, "");
}

}  // namespace again_test
