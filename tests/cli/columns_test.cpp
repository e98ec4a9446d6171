// Every command that writes points keeps the class, the ink and the ellipse of each, or refuses the
// format in a line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/expectations.h"
#include "cli/pictures.h"
#include "files/formats.h"
#include "files/read_points.h"
#include "program.h"

namespace columns_test {

using namespace lacuna::tests;
using lacuna::files::Format;
using lacuna::files::PointsOfFile;

struct Columns {
    std::string name;
    Words makes;       // a command that makes such points
    std::string loss;  // the word for it in a refusal
};

std::vector<Columns> all_columns(const Folder& folder) {
    const std::string picture = grey_picture(folder, 2, 1, bytes({60, 120}));
    return {{"classes", {"sample", "--class", "oak:.06", "--class", "elm:.03"}, "class"},
            {"inks",
             {"stipple", picture, "--inks", "red,blue", "--count", "60", "--relax", "2"},
             "ink"},
            {"ellipses", {"sample", "--stretch", ".1:.05@30", "--ellipse-columns"}, "ellipse"}};
}

std::size_t columns_in(const PointsOfFile& file, const std::string& name) {
    return name == "classes" ? file.classes.of_point.size()
           : name == "inks"  ? file.inks.of_point.size()
                             : file.ellipses.size();
}

// For each point, sorted: its place and what belongs to it.
std::vector<std::string> rows_of(const PointsOfFile& file) {
    std::vector<std::string> rows;
    for (std::size_t i = 0; i < file.points.size(); ++i) {
        std::string row = std::to_string(file.points[i].x) + " " + std::to_string(file.points[i].y);
        for (const auto* layers : {&file.classes, &file.inks})
            if (!layers->of_point.empty()) row += " " + layers->names[layers->of_point[i]];
        if (!file.ellipses.empty()) row.append(" ").append(std::to_string(file.ellipses[i].angle));
        rows.push_back(row);
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

PointsOfFile read(const std::string& path) {
    return lacuna::files::read_points(path);
}

TEST(Columns, AreWrittenByEachCommandInEachFormatOrRefused) {
    const Folder folder;
    for (const Columns& columns : all_columns(folder)) {
        const std::string given = folder.path(columns.name + ".csv");
        expect_success(joined(columns.makes, {"--quiet", "-o", given}));
        const Words order{"order", given}, relax{"relax", given, "--iterations", "2"};
        for (const Words& command : {columns.makes, order, relax})
            for (const Format& format : lacuna::files::formats()) {
                SCOPED_TRACE(command[0] + " of " + columns.name + " as " +
                             std::string(format.name()));
                const std::string path = folder.path("out" + std::string(format.extension));
                const Outcome outcome = run(joined(command, {"--quiet", "-o", path}));
                if (command[0] == "relax" && columns.name == "ellipses") {
                    expect_one_error(outcome, 3, {"ellipses.csv", "columns a, b and angle"});
                    continue;
                }
                if (!format.has_columns) {
                    EXPECT_NE(outcome.exit_code, 0);
                    expect_one_error(outcome, outcome.exit_code,
                                     {columns.loss + " of each", ".csv .npy .ply .geojson .json"});
                    continue;
                }
                EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
                // A .npy has no names: three columns might be a third coordinate.
                if (format.medium || (format.name() == "npy" && columns.name != "ellipses"))
                    continue;
                const PointsOfFile written = read(path);
                EXPECT_EQ(columns_in(written, columns.name), written.points.size());
                if (command[0] == "order" && format.name() != "ply") {
                    EXPECT_EQ(rows_of(written), rows_of(read(given)));
                }
            }
    }
}

TEST(Columns, AtRandomFollowFromTheSeed) {
    const Folder folder;
    const Words made{"sample", "--class", "a:.1", "--seed", "3", "--columns", "angle,size:2..3"};
    const auto path = [&](const char* end) { return folder.path(std::string("a.") + end); };
    expect_success(joined(made, {"--quiet", "-o", path("csv"), "-o", path("geojson"), "-o",
                                 path("json"), "-o", path("ply")}));
    const std::string csv = content_of(path("csv"));
    EXPECT_TRUE(csv.starts_with("x,y,angle,size,class\n"));
    EXPECT_EQ(run(joined(made, {"--format", "csv"})).out, csv);
    for (const char* const end : {"csv", "geojson", "ply"})
        EXPECT_EQ(read(path(end)).other_columns, (Words{"angle", "size"})) << end;
    const nlohmann::json set = nlohmann::json::parse(content_of(path("json")));
    const nlohmann::json map = nlohmann::json::parse(content_of(path("geojson")));
    for (std::size_t i = 0; i < set["points"].size(); ++i) {
        const double size = set["size"][i], angle = set["angle"][i];
        EXPECT_TRUE(size >= 2 && size < 3 && angle >= 0 && angle < 360);
        const auto& properties = map["features"][i]["properties"];
        EXPECT_NEAR(properties["size"].get<double>(), size, 1e-8);
        EXPECT_EQ(map["features"][i]["geometry"]["coordinates"], set["points"][i]);
    }
}

TEST(Columns, OfStandardOutputAreKeptInAFormatThatHasThem) {
    const Outcome csv = run({"sample", "--class", "a:.2", "--format", "csv"});
    EXPECT_EQ(csv.exit_code, 0) << csv.err;
    EXPECT_TRUE(csv.out.starts_with("x,y,class\n"));
}

TEST(Columns, OfSizesAreMadeAnewByOrderAndRelax) {
    const Folder folder;
    const std::string dots = folder.path("dots.csv"), out = folder.path("out.csv");
    write_file(dots, "x,y,radius,x_mm,y_mm,radius_mm\n.1,.2,.1,1,1,1\n.5,.6,.1,1,1,1\n");
    for (const char* const command : {"order", "relax"}) {
        expect_success({command, dots, "--quiet", "--dot-size", "2mm", "-o", out});
        EXPECT_EQ(read(out).other_columns.size(), 4U);
    }
}

TEST(Columns, OfInksKeepTheirColours) {
    const Folder folder;
    const std::string picture = grey_picture(folder, 2, 1, bytes({60, 120}));
    const std::string json = folder.path("a.json"), svg = folder.path("a.svg");
    expect_success({"stipple", picture, "--inks", "sea=#0083b8,red", "--count", "40", "--relax",
                    "1", "--quiet", "-o", json});
    expect_success({"order", json, "--quiet", "-o", svg});
    expect_has(content_of(svg), {"#0083b8", "#e01020", "1 sea", "2 red"});
}

}  // namespace columns_test
