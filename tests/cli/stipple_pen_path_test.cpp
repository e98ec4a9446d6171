// Given --pen-path, dots come in the order of a short way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/stippling.h"
#include "program.h"

namespace {

using namespace lacuna::test;
using lacuna::Point;

double length_of(const std::vector<Point>& points) {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    return length;
}

std::vector<Point> sorted(std::vector<Point> points) {
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    });
    return points;
}

TEST(APenPath, HasTheSameDotsAndIsShort) {
    const Folder folder;
    const std::string report = folder.path("report.json");
    const std::vector<Point> admitted = points_of(kRaccoon, {"--count", "5000"});
    const std::vector<Point> path =
        points_of(kRaccoon, {"--count", "5000", "--pen-path", "--report", report});
    EXPECT_EQ(sorted(path), sorted(admitted));
    EXPECT_GT(length_of(admitted), 2000);
    EXPECT_LT(length_of(path), 65);  // a Hilbert curve: 72

    const auto json = nlohmann::json::parse(content_of(report));
    EXPECT_NEAR(json.at("pen_path").at("length").get<double>(), length_of(path), 1e-9);
    EXPECT_NEAR(json.at("pen_path").at("length_as_admitted").get<double>(), length_of(admitted),
                1e-6);
    EXPECT_GT(json.at("seconds").at("pen_path"), 0);
}

TEST(APenPath, OnPaperIsDrawnInItsOrderAndInMillimetres) {
    const Folder folder;
    const Names request{"--count", "300", "--pen-path"};
    const std::vector<Point> path = points_of(kRaccoon, request);
    const Names on_paper = joined(request, {"--paper-size", "A4", "--margin", "20mm"});
    ASSERT_EQ(stipple(kRaccoon, on_paper, folder.path("a.svg")).exit_code, 0);
    const std::string svg = content_of(folder.path("a.svg"));
    EXPECT_NE(svg.find("width=\"297mm\" height=\"210mm\""), std::string::npos)
        << "A4 lies across for a wide picture";
    // 170 mm high between the margins, and so 226.67 mm wide.
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
