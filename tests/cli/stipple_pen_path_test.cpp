// Given a pen, dots come in the order of a short way.
#include <gtest/gtest.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/stippling.h"
#include "program.h"

namespace {

using namespace lacuna::tests;
using lacuna::Point;

TEST(APenPath, OnPaperIsDrawnInItsOrderAndInMillimetres) {
    const Folder folder;
    const Names request{"--count", "300", "--dot-size", "2mm"};
    const std::vector<Point> path = points_of(kRaccoon, request);
    const Names on_paper = joined(request, {"--paper-size", "A4", "--margin", "19mm"});
    const std::string report = folder.path("report.json");
    ASSERT_EQ(
        stipple(kRaccoon, joined(on_paper, {"--report", report}), folder.path("a.svg")).exit_code,
        0);
    const auto json = nlohmann::json::parse(content_of(report));
    EXPECT_LT(json.at("pen_path").at("length"), json.at("pen_path").at("length_as_admitted"));
    EXPECT_GT(json.at("seconds").at("pen_path"), 0);
    const std::string svg = content_of(folder.path("a.svg"));
    EXPECT_NE(svg.find("width=\"297mm\" height=\"210mm\""), std::string::npos)
        << "A4 lies across for a wide picture";
    // 170 mm high between the margins and half of the pen, and so 226.67 mm wide.
    const double scale = 170 / 0.75;
    std::size_t at = 0;
    for (const Point& point : path) {
        at = svg.find('M', at + 1);
        ASSERT_NE(at, std::string::npos);
        const std::size_t blank = svg.find(' ', at);
        EXPECT_NEAR(std::stod(svg.substr(at + 1, blank - at)), (297 - scale) / 2 + point.x * scale,
                    1e-3);
        EXPECT_NEAR(std::stod(svg.substr(blank)), 190 - point.y * scale, 1e-3);
    }
    EXPECT_EQ(svg.find('M', at + 1), std::string::npos);
}

}  // namespace
