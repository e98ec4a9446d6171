// Given pictures by the command, programs for plotters and viewers see every dot, and see it round.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstddef>
#include <sstream>
#include <string>

#include "cli/stippling.h"
#include "program.h"
#include "required.h"

namespace {

using namespace lacuna::tests;

// The output of viewers.py, run by the Python that has vpype and pdfium.
std::string seen(const std::string& what, const std::string& path) {
    Setting setting;
    setting.program = LACUNA_VIEWERS_PYTHON;
    const Outcome outcome = run({LACUNA_VIEWERS, what, path}, setting);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
}

class Viewers : public testing::Test {
protected:
    void SetUp() override {
        if (access(LACUNA_VIEWERS_PYTHON, X_OK) == 0) return;
        if (is_required("viewers")) FAIL() << "no " LACUNA_VIEWERS_PYTHON;
        GTEST_SKIP() << "no " LACUNA_VIEWERS_PYTHON ": ./bootstrap.sh test makes it";
    }
    const Folder folder_;
};

TEST_F(Viewers, GivenAPlottersFileThenVpypeSeesAPathADotAndNoOther) {
    const std::string path = folder_.path("plot.svg");
    for (const Names& paper : {Names{}, Names{"--paper-size", "A4", "--margin", "15mm"},
                               Names{"--paper-size", "A4", "--dot-size", "0.5mm"}}) {
        const Names arguments = joined({"--count", "700", "--pen-path"}, paper);
        ASSERT_EQ(stipple(kRaccoon, arguments, path).exit_code, 0);
        EXPECT_EQ(seen("paths", path), "700\n");
    }
}

TEST_F(Viewers, GivenTinyDotsThenVpypeSeesThemAll) {
    const std::string path = folder_.path("plot.svg");
    const Names arguments{"--count", "700",    "--pen-path", "--paper-size", "A4", "--dot-size",
                          "0.001mm", "--seed", "2"};
    ASSERT_EQ(stipple(kRaccoon, arguments, path).exit_code, 0);
    EXPECT_EQ(seen("paths", path), "700\n");
}

TEST_F(Viewers, GivenAPdfThenADotIsRoundInPdfium) {
    const std::string path = folder_.path("dot.pdf");
    expect_success({"sample", "--radius", "0.03", "--limit", "1", "--quiet", "-o", path});
    std::istringstream words(seen("dots", path));
    int width = 0, height = 0;
    double dark = 0;
    words >> width >> height >> dark;
    // A third of the radius on 512 points of 8 pixels: 40.96 pixels.
    EXPECT_NEAR(width, 82, 1);
    EXPECT_EQ(width, height);
    EXPECT_NEAR(dark, 3.14159 * 40.96 * 40.96, 60);
}

}  // namespace
