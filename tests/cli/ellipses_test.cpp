// Ellipses, as a user of the command meets them: options, files, proofs and refusals.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "files/npy.h"
#include "files/point_files.h"
#include "files/read_points.h"
#include "files/read_whole.h"
#include "program.h"

namespace ellipses_test {

using namespace lacuna;
using namespace lacuna::tests;
using Names = std::vector<std::string>;

Outcome run_with(const std::string& name, Names first, const Names& more) {
    first.insert(first.begin(), name);
    first.insert(first.end(), more.begin(), more.end());
    return tests::run(first);
}

// An array of rows x columns x 3 doubles.
std::string npy_of(std::size_t rows, std::size_t columns, const std::vector<double>& values,
                   const std::string& type = "<f8") {
    std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (" +
                         std::to_string(rows) + ", " + std::to_string(columns) + ", 3), }";
    header.resize(118, ' ');
    header.back() = '\n';
    std::string bytes = std::string(files::kNpyMagic) + std::string("\x01\x00\x76\x00", 4) + header;
    const auto* const data = reinterpret_cast<const char*>(values.data());
    return bytes + std::string(data, values.size() * sizeof(double));
}

TEST(Ellipses, OfAnArrayAreRefutedAtAnotherScale) {
    const Folder folder;
    const std::string array = folder.path("e.npy"), csv = folder.path("a.csv");
    files::write_whole(array, npy_of(2, 3,
                                     {0.1, 0.02, 0.3, 0.02, 0.1, 0.3, 0, 0, 0,  //
                                      0.05, 0.05, 0, 0.03, 0.09, 1, 0.1, 0.03, -2}));
    ASSERT_EQ(run_with("sample", {"--quiet", "--ellipses", array}, {"-o", csv}).exit_code, 0);
    EXPECT_EQ(run_with("verify", {csv, "--ellipses", array}, {}).exit_code, 0);
    // Half as large ones leave room, and twice as large ones overlap.
    EXPECT_EQ(run_with("verify", {csv, "--ellipses", array, "--scale", "0.5"}, {}).exit_code, 1);
    EXPECT_EQ(run_with("verify", {csv, "--ellipses", array, "--scale", "2"}, {}).exit_code, 1);
}

TEST(OneEllipse, IsTheArrayOfOnePixel) {
    const Folder folder;
    const std::string array = folder.path("e.npy");
    const std::string a = folder.path("a.npy"), b = folder.path("b.npy"),
                      json = folder.path("c.json");
    const double angle = std::acos(-1.0) / 6;
    files::write_whole(array, npy_of(1, 1, {0.05, 0.01, angle}));
    ASSERT_EQ(run_with("sample", {"--quiet", "--ellipses", array, "--torus"}, {"-o", a}).exit_code,
              0);
    ASSERT_EQ(run_with("sample", {"--quiet", "--stretch", "0.05:0.01@30", "--torus"},
                       {"-o", b, "-o", json})
                  .exit_code,
              0);
    EXPECT_EQ(files::read_whole(a), files::read_whole(b));
    EXPECT_NE(files::read_whole(json).find("--stretch 0.05:0.01@30"), std::string::npos);
    EXPECT_EQ(run_with("verify", {b, "--stretch", "0.01:0.05@120", "--torus"}, {}).exit_code, 0);
}

TEST(Ellipses, AlongTheEdgesOfAPictureAreColumnsAndThoseOfStipple) {
    const Folder folder;
    const std::string csv = folder.path("a.csv"), dots = folder.path("b.csv");
    const Names along{"--field", LACUNA_EXAMPLES "/raccoon.png", "--scale", "0.03", "--along", "4"};
    ASSERT_EQ(run_with("sample", along, {"--quiet", "--ellipse-columns", "-o", csv}).exit_code, 0);
    EXPECT_TRUE(files::read_whole(csv).starts_with("x,y,a,b,angle\n"));
    // stipple makes the same set.
    ASSERT_EQ(run_with("stipple", {LACUNA_EXAMPLES "/raccoon.png", "--scale", "0.03"},
                       {"--along", "4", "--quiet", "--ellipse-columns", "-o", dots})
                  .exit_code,
              0);
    EXPECT_EQ(files::read_whole(dots), files::read_whole(csv));
}

TEST(Ellipses, AreDrawnAsLargeAsTheirRadiiSay) {
    const Folder folder;
    const std::string svg = folder.path("a.svg");
    ASSERT_EQ(run_with("sample", {"--quiet", "--stretch", "0.3:0.03@0"}, {"-o", svg}).exit_code, 0);
    // A third of the radii: of 512 points.
    EXPECT_NE(files::read_whole(svg).find("a51.2 5.12 0 1 0 102.4000 0.0000"), std::string::npos)
        << files::read_whole(svg);
}

}  // namespace ellipses_test
