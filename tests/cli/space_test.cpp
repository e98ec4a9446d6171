// Sets on meshes and in volumes: the command makes the library's sets, every file holds them, and
// verify proves them from each.
#include <gtest/gtest.h>
#include <lacuna/domains.h>
#include <lacuna/space.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "expectations.h"
#include "files/read_points.h"
#include "pictures/image.h"
#include "program.h"
#include "required.h"

namespace space_test {

using namespace lacuna;
using namespace lacuna::tests;
using Json = nlohmann::json;

// A wedge: a square that is folded in the middle.
const std::string kWedge =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 1\nv 2 1 1\nf 1 2 3 4\nf 2 5 6 3\n";

class InSpace : public testing::Test {
protected:
    void SetUp() override {
        write_file(mesh_, kWedge);
        const Outcome tried = run({"sample", "--on", mesh_, "--radius", "1"});
        if (tried.exit_code != 0 && !is_required("assimp")) GTEST_SKIP() << tried.err;
    }
    std::vector<Point3> made(const Words& options, const std::string& name = "made.txt") const {
        const std::string path = folder_.path(name);
        expect_success(joined(joined({"sample"}, options), {"--quiet", "-o", path}));
        return files::read_points(path, files::Lie::in_space).in_space();
    }
    // The verdict on a file, and the exit code.
    static void expect_verdict(const Words& words, int code, const std::string& part) {
        const Outcome outcome = run(joined({"verify"}, words));
        EXPECT_EQ(outcome.exit_code, code) << outcome.err;
        expect_has(line_of(outcome.out, "verdict"), {part});
    }

    Folder folder_;
    const std::string mesh_ = folder_.path("wedge.obj");
};

TEST_F(InSpace, OptionsArriveInTheRequest) {
    const Mesh mesh = read_mesh(mesh_);
    EXPECT_EQ(made({"--on", mesh_, "--radius", "0.1", "--seed", "7", "--limit", "40"}),
              sample_surface({.mesh = &mesh, .radius = 0.1, .limit = 40, .seed = 7}).points);
    const SpaceRequest of_volume{
        .volume = {1, 2, 0.5, Boundary::torus}, .count = 300, .round_size = 9};
    EXPECT_EQ(made({"--domain", "1x2x0.5", "--torus", "--count", "300", "--round-size", "9",
                    "--backend", "reference"}),
              sample_volume(of_volume).points);
    const std::vector<Point3> kept{{0.25, 0.75, 0}, {1.5, 0.5, 0.5}};
    write_file(folder_.path("kept.csv"), "x,y,z\n0.25,0.75,0\n1.5,0.5,0.5\n");
    EXPECT_EQ(made({"--on", mesh_, "--radius", "0.1", "--keep", folder_.path("kept.csv")}),
              sample_surface({.mesh = &mesh, .radius = 0.1, .keep = kept}).points);
    expect_verdict({folder_.path("made.txt"), "--on", mesh_, "--radius", "0.1", "--keep",
                    folder_.path("kept.csv")},
                   0, "a maximal Poisson-disk set of radius 0.1, to a tolerance of ");
}

TEST_F(InSpace, EveryFileHoldsTheSet) {
    const std::vector<Point3> points = made({"--on", mesh_, "--radius", "0.1"});
    for (const std::string name : {"a.txt", "a.csv", "a.npy", "a.ply", "a.json"}) {
        EXPECT_EQ(made({"--on", mesh_, "--radius", "0.1"}, name), points);
        expect_verdict({folder_.path(name), "--on", mesh_, "--radius", "0.1"}, 0, "a maximal");
        expect_verdict({folder_.path(name), "--on", mesh_, "--radius", "0.11"}, 1, "closer than");
        expect_verdict({folder_.path(name), "--on", mesh_, "--radius", "0.09"}, 1, "there is room");
        expect_verdict({folder_.path(name), "--domain", "1x1x1", "--radius", "0.1"}, 1,
                       "lies outside the volume [0, 1] x [0, 1] x [0, 1]");
        if (name == "a.json") continue;
        expect_one_error(run({"relax", folder_.path(name), "-o", folder_.path("b.csv")}), 3,
                         {name});
    }
    const Json json = Json::parse(content_of(folder_.path("a.json")));
    EXPECT_EQ(json["normals"].size(), points.size());
    EXPECT_EQ(json["triangles"].size(), points.size());
    EXPECT_EQ(json["options"]["on"], mesh_);
    expect_has(content_of(folder_.path("a.ply")), {"property double nz\nproperty int triangle\n"});
    expect_one_error(run({"sample", "--on", mesh_, "--radius", "1", "-o", folder_.path("a.pdf")}),
                     2, {"a.pdf: has no place for three coordinates"});
}

TEST_F(InSpace, APictureHasThreeViewsWithoutHiddenPoints) {
    const std::string png = folder_.path("a.png");
    // A square far above the wedge hides it from above: the third view.
    write_file(mesh_, kWedge + "v 0 0 2\nv 2 0 2\nv 2 1 2\nv 0 1 2\nf 7 8 9 10\n");
    write_file(folder_.path("kept.csv"), "x,y,z\n0.5,0.5,0\n0.5,0.25,2\n");
    expect_success({"sample", "--on", mesh_, "--radius", "0.2", "--keep", folder_.path("kept.csv"),
                    "--limit", "2", "--quiet", "-o", png});
    const auto picture = pictures::read_image(png);
    EXPECT_EQ(picture.columns, 240U + 440 + 440);  // sides 1, 2 and 2, and 20 pixels around each
    ASSERT_EQ(picture.rows, 440U);
    const auto is_dark = [&](std::size_t column, std::size_t row) {
        return picture.luminance[row * picture.columns + column] < 0.1;
    };
    EXPECT_TRUE(is_dark(680 + 20 + 100, 100 + 20 + 150));   // (0.5, 0.25, 2) from above
    EXPECT_FALSE(is_dark(680 + 20 + 100, 100 + 20 + 100));  // (0.5, 0.5, 0) lies below it
}

TEST_F(InSpace, AJsonSaysWhatItsSetWasMadeWith) {
    const std::string json = folder_.path("a.json");
    made({"--on", mesh_, "--radius", "0.1"}, "a.json");
    expect_verdict({json, "--on", mesh_}, 0, "a maximal");
    expect_one_error(run({"verify", json}), 2, {"made with --on", "give that too"});
    made({"--domain", "1x1x0.5", "--torus", "--radius", "0.2"}, "a.json");
    expect_verdict({json}, 0, "a maximal");
    expect_one_error(run({"verify", json, "--domain", "2x1"}), 2, {"2x1 with points in space"});
    made({"--domain", "1x1x0.5", "--count", "100"}, "a.json");
    expect_verdict({json}, 1, "the file says that it is not: see --distances-only");
    const Outcome report = run({"verify", json, "--distances-only", "--json"});
    EXPECT_EQ(report.exit_code, 0);
    EXPECT_EQ(Json::parse(report.out)["sets"][0]["domain"]["depth"], 0.5);
}

TEST_F(InSpace, TheLastLineAndTheReportSayWhatWasMade) {
    const std::string report = folder_.path("report.json");
    const Outcome outcome = run({"sample", "--on", mesh_, "--count", "200", "-o",
                                 folder_.path("a.npy"), "--report", report});
    EXPECT_TRUE(outcome.err.starts_with("200 points on " + mesh_ + ", radius 0.0")) << outcome.err;
    expect_has(outcome.err, {", not maximal, "});
    const Json json = Json::parse(content_of(report));
    EXPECT_EQ(json["count"], 200);
    EXPECT_EQ(json["request"]["on"], mesh_);
    EXPECT_EQ(json["points_sha256"].get<std::string>().size(), 64U);
}

}  // namespace space_test
