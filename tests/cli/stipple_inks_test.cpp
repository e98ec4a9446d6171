// lacuna stipple --inks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/stippling.h"
#include "program.h"
#include "text.h"

namespace {

using namespace lacuna::tests;

// Red at the left, blue at the right, grey above, and white between.
const std::string kDrawing =
    "P3 4 3 255 90 90 90 90 90 90 90 90 90 90 90 90 "
    "230 20 20 255 255 255 255 255 255 20 40 230 "
    "230 20 20 255 255 255 255 255 255 20 40 230";

struct Drawing {
    Folder folder;
    std::string path(const std::string& name) const { return folder.path(name); }

    Outcome stipple(Names arguments) const {
        write_file(path("drawing.ppm"), kDrawing);
        arguments.insert(arguments.begin(), {"stipple", path("drawing.ppm")});
        return run(arguments);
    }
    nlohmann::json json(Names arguments) const {
        arguments.insert(arguments.end(), {"--quiet", "-o", path("a.json")});
        const Outcome outcome = stipple(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return nlohmann::json::parse(content_of(path("a.json")));
    }
};

TEST(StippleInks, AreSaidInAJson) {
    const Drawing drawing;
    const auto set = drawing.json({"--inks", "cmyk", "--count", "400"});
    ASSERT_EQ(set.at("points").size(), 400U);
    const std::vector<int> inks = set.at("ink");
    EXPECT_TRUE(std::is_sorted(inks.begin(), inks.end()));
    EXPECT_EQ(set.at("mode"), "stratified");
    EXPECT_EQ(set.at("options").at("black_ink"), 0.8);
    EXPECT_EQ(set.at("options").at("inks").at(3).at("colour"), "#1d1d1b");
}

TEST(StippleInks, AreLayersAndColumns) {
    const Drawing drawing;
    const Outcome outcome = drawing.stipple(
        {"--inks", "red,sea=#0083b8", "--count", "90", "-o", drawing.path("a.svg"), "-o",
         drawing.path("a.csv"), "-o", drawing.path("a.png"), "-o", drawing.path("a.pdf")});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "90 dots (red ")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, ", sea ")) << outcome.err;
    const std::string svg = content_of(drawing.path("a.svg"));
    EXPECT_TRUE(contains(svg, "inkscape:label=\"1 red\""));
    EXPECT_TRUE(contains(svg, "inkscape:label=\"2 sea\""));
    EXPECT_EQ(content_of(drawing.path("a.csv")).substr(0, 8), "x,y,ink\n");
}

}  // namespace
