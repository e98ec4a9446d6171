// Given a set's file, the file says how the set was made, and analyze and verify use that.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/pictures.h"
#include "expectations.h"
#include "files/read_points.h"
#include "pdf_text.h"
#include "program.h"

namespace origin_test {

using namespace lacuna::tests;
using Json = nlohmann::json;

TEST(AJsonFile, TellsTheRequestThatMadeItAndACommandThatMakesItAnew) {
    const Folder folder;
    const std::string path = folder.path("a.json");
    expect_success({"sample", "--radius", "0.1", "--torus", "--seed", "7", "--domain", "2x1",
                    "--backend", "reference", "--threads", "1", "--quiet", "-o", path});
    const Json json = Json::parse(content_of(path));
    EXPECT_EQ(json.at("boundary"), "torus");
    EXPECT_EQ(json.at("seed"), 7);
    EXPECT_EQ(json.at("mode"), "exact");
    EXPECT_EQ(json.at("radius"), 0.1);
    EXPECT_EQ(json.at("maximal"), true);
    EXPECT_EQ("lacuna " + json.at("version").get<std::string>() + "\n", run({"version"}).out);
    EXPECT_EQ(json.at("command"), "lacuna sample --radius 0.1 --domain 2x1 --torus --seed 7");
    EXPECT_EQ(json.at("options").at("lines_per_radius"), 6);
    EXPECT_FALSE(json.at("options").contains("threads"));
    // Whatever made it, the bytes are the same.
    const Outcome other = run({"sample", "--radius", "0.1", "--torus", "--seed", "7", "--domain",
                               "2x1", "--format", "json"});
    EXPECT_EQ(other.out, content_of(path));
}

TEST(AJsonFile, OfAnyFileNameIsReadBack) {
    const Folder folder;
    const std::string image = folder.path("it's \xff & <odd>.pgm");
    write_file(image, pgm(2, 2, std::string(4, '\x40')));
    const Outcome json = run({"stipple", image, "--count", "50", "--format", "json"});
    ASSERT_EQ(json.exit_code, 0) << json.err;
    EXPECT_NE(Json::parse(json.out).at("command").get<std::string>().find("it'\\''s"),
              std::string::npos);
    write_file(folder.path("a.json"), json.out);
    EXPECT_EQ(lacuna::files::read_points(folder.path("a.json")).points.size(), 50U);
    const Outcome svg = run({"stipple", image, "--count", "50", "--format", "svg"});
    expect_has(svg.out, {"&amp; &lt;odd>", "\xef\xbf\xbd", "seed 0"});
}

TEST(APicture, TellsSeedVersionAndCommand) {
    const Outcome svg = run({"sample", "--radius", "0.2", "--seed", "9", "--format", "svg"});
    const std::string version = run({"version"}).out.substr(7);
    expect_has(svg.out, {"<dc:source>lacuna sample --radius 0.2 --seed 9</dc:source>", "seed 9",
                         "Lacuna " + version.substr(0, version.size() - 1)});
    const Outcome pdf = run({"sample", "--radius", "0.2", "--seed", "9", "--format", "pdf"});
    expect_has(lacuna::tests::pdf_text(pdf.out), {"/Subject (lacuna sample --radius 0.2 --seed 9)",
                                                  "/Keywords (seed 9)", "/Creator (Lacuna "});
}

TEST(Analyze, TakesAFileWithoutADomainForOneOfTheDomainGiven) {
    const Folder folder;
    const std::string told = folder.path("a.json");
    expect_success({"sample", "--radius", "16", "--domain", "512x512", "--quiet", "-o", told});
    write_file(folder.path("b.csv"), "0.1,0.1\n0.9,0.9\n");
    expect_success({"analyze", told, folder.path("b.csv"), "--domain", "512x512", "--quiet"});
}

TEST(Analyze, WritesItsNumbersAsJsonWhereJsonIsAskedFor) {
    const Folder folder;
    write_file(folder.path("b.csv"), "0.1,0.1\n0.9,0.9\n");
    const Outcome json = run({"analyze", folder.path("b.csv"), "--json", "--quiet"});
    EXPECT_EQ(json.out, run({"analyze", folder.path("b.csv"), "-o", "-", "--quiet"}).out);
    EXPECT_EQ(Json::parse(json.out).at("sets"), 1);
}

TEST(Verify, OfAStippledJsonAsksForDistancesOnly) {
    const Folder folder;
    const std::string path = folder.path("a.json");
    for (const std::string mode : {"cells", "stratified"}) {
        expect_success(
            {"stipple", kRaccoon, "--count", "300", "--start", mode, "--quiet", "-o", path});
        expect_one_error(run({"verify", path}), 2, {"mode " + mode, "--distances-only"});
        expect_success({"verify", path, "--distances-only"});
    }
}

TEST(Dots, HaveTheirSizesAndMillimetresInFilesWhereADotSizeIsGiven) {
    const Folder folder;
    const Words request{"stipple",  kRaccoon,   "--count", "40",      "--paper-size",
                        "100x80mm", "--margin", "9mm",     "--quiet", "--dot-size"};
    const auto made = [&](const std::string& size, const std::string& name) {
        Words words = request;
        words.insert(words.end(), {size, "-o", folder.path(name)});
        expect_success(words);
        return content_of(folder.path(name));
    };
    const std::string csv = made("2mm", "a.csv");
    EXPECT_TRUE(csv.starts_with("x,y,radius,x_mm,y_mm,radius_mm\n")) << csv;
    double x = 0, y = 0, radius = 0, x_mm = 0, y_mm = 0, radius_mm = 0;
    ASSERT_EQ(std::sscanf(csv.c_str() + csv.find('\n'), "%lf,%lf,%lf,%lf,%lf,%lf", &x, &y, &radius,
                          &x_mm, &y_mm, &radius_mm),
              6);
    // The picture is 80 mm wide and 60 mm high, in the middle of the sheet: dots of 2 mm around its
    // edges do not lie in the margin.
    EXPECT_NEAR(x_mm, 10 + 80 * x, 1e-6);
    EXPECT_NEAR(y_mm, 10 + 80 * y, 1e-6);
    EXPECT_NEAR(radius_mm, 1, 1e-9);
    EXPECT_NEAR(radius, 1.0 / 80, 1e-9);

    const auto points = lacuna::files::read_points(folder.path("a.csv")).points;
    ASSERT_EQ(points.size(), 40U);
    for (const std::string name : {"b.npy", "b.ply", "b.json"}) {
        made("2mm", name);
        EXPECT_EQ(lacuna::files::read_points(folder.path(name)).points, points) << name;
    }
    const Json dots = Json::parse(content_of(folder.path("b.json"))).at("dots");
    EXPECT_EQ(dots.at("mm_per_unit"), 80);
    EXPECT_EQ(dots.at("radii").size(), 40U);
    EXPECT_NE(content_of(folder.path("b.ply")).find("property double radius_mm\n"),
              std::string::npos);
    EXPECT_NE(content_of(folder.path("b.npy")).find("(40, 6)"), std::string::npos);
    // Sized by radius, the dots of any two tones differ.
    EXPECT_NE(made("radius", "c.csv"), csv);
}

TEST(Sample, TakesPaperAndDotSizes) {
    const Folder folder;
    const std::string path = folder.path("a.svg");
    expect_success({"sample", "--radius", "0.2", "--paper-size", "A1", "--margin", "20mm",
                    "--dot-size", "3mm", "--quiet", "-o", path});
    expect_has(content_of(path), {"width=\"594mm\" height=\"841mm\"", "stroke-width=\"3\""});
    expect_success({"sample", "--radius", "0.2", "--paper-size", "Legal", "--quiet", "-o", path});
    expect_has(content_of(path), {"width=\"215.9mm\" height=\"355.6mm\""});
}

}  // namespace origin_test
