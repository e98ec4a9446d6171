// Columns besides the coordinates: of dots and of ellipses, in each format that has columns.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "files/formats.h"
#include "files/point_files.h"
#include "files/read_points.h"
#include "text.h"

namespace lacuna::files {
namespace {

using tests::contains;

const std::vector<Point> kPoints{{0.25, 0.5}, {0.75, 1}};
const std::vector<Ellipse> kEllipses{{0.5, 0.125, -1.5}, {0.25, 0.25, 0}};

PointSet set_of_ellipses(const Dots* dots = nullptr) {
    PointSet set{kPoints};
    set.ellipses = kEllipses;
    set.writes_ellipses = true;
    set.dots = dots;
    return set;
}

std::string text(const char* format, const PointSet& set) {
    return encode(set, *find_format(format));
}

TEST(EllipseColumns, AreTwoRadiiAndAnAngle) {
    EXPECT_EQ(text("csv", set_of_ellipses()),
              "x,y,a,b,angle\n0.25,0.5,0.5,0.125,-1.5\n0.75,1,0.25,0.25,0\n");
    EXPECT_TRUE(contains(text("ply", set_of_ellipses()),
                         "property double z\nproperty double a\nproperty double b\n"
                         "property double angle\nend_header\n0.25 0.5 0 0.5 0.125 -1.5\n"));
    EXPECT_TRUE(contains(text("json", set_of_ellipses()),
                         "\"ellipses\":[\n[0.5,0.125,-1.5],\n[0.25,0.25,0.0]],\n\"points\":["));
    EXPECT_TRUE(contains(text("npy", set_of_ellipses()), "'shape': (2, 5)"));
    PointSet nobody;
    nobody.writes_ellipses = true;
    EXPECT_TRUE(contains(text("json", nobody), "\"ellipses\":[],"));
}

TEST(EllipseColumns, ComeAfterThoseOfDots) {
    const Dots dots{{0.125, 0.25}, 100, 10, 20};
    EXPECT_TRUE(contains(text("csv", set_of_ellipses(&dots)),
                         "x,y,radius,x_mm,y_mm,radius_mm,a,b,angle\n"
                         "0.25,0.5,0.125,35,70,12.5,0.5,0.125,-1.5\n"));
    EXPECT_TRUE(contains(text("npy", set_of_ellipses(&dots)), "'shape': (2, 9)"));
}

TEST(EllipseColumns, AreReadAgain) {
    const Dots dots{{0.125, 0.25}, 100, 10, 20};
    for (const char* const format : {"csv", "npy", "ply", "json"})
        for (const Dots* const some : {static_cast<const Dots*>(nullptr), &dots}) {
            const std::string bytes = text(format, set_of_ellipses(some));
            const PointsOfFile file = find_format(format)->decode(bytes, "file");
            EXPECT_EQ(file.points, kPoints) << format;
            ASSERT_EQ(file.ellipses.size(), 2U) << format;
            EXPECT_EQ(file.ellipses[0].b, 0.125) << format;
            EXPECT_EQ(file.ellipses[0].angle, -1.5) << format;
            EXPECT_EQ(file.other_columns.size(), some == nullptr ? 0U : 4U) << format;
        }
}

TEST(Columns, OfClassesInksAndEllipsesAreRefusedWhereAFormatHasNoPlaceForThem) {
    const std::vector<Layer> layers =
        layers_of_classes(std::vector<std::string>{"oak", "elm"}, std::vector<std::uint8_t>{1, 0});
    const std::vector<std::uint8_t> of_points{1, 0};
    PointSet classes{kPoints};
    classes.layers = layers;
    classes.layer_of_point = of_points;
    classes.layers_are = LayersAre::classes;
    PointSet inks = classes;
    inks.layers_are = LayersAre::inks;
    for (const Format& format : formats()) {
        for (const PointSet& set : {classes, inks, set_of_ellipses()})
            if (format.has_columns) {
                EXPECT_NO_THROW(encode(set, format)) << format.name();
            } else {
                EXPECT_THROW(encode(set, format), BadRequest) << format.name();
            }
        EXPECT_NO_THROW(encode({kPoints}, format)) << format.name();
    }
    for (const char* const format : {"csv", "ply", "json"}) {
        EXPECT_EQ(find_format(format)->decode(text(format, classes), "f").classes.of_point.size(),
                  2U);
        EXPECT_EQ(find_format(format)->decode(text(format, inks), "f").inks.of_point.size(), 2U);
    }
}

TEST(EllipseColumns, AreOnlyWrittenOnRequest) {
    PointSet set = set_of_ellipses();
    set.writes_ellipses = false;
    EXPECT_TRUE(contains(text("csv", set), "x,y\n"));
    EXPECT_FALSE(contains(text("json", set), "ellipses"));
}

}  // namespace
}  // namespace lacuna::files
