// Given a point file with something wrong in it, the reader says what and where in one line.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <ostream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "files/point_files.h"
#include "files/read_points.h"
#include "files/read_points_bytes.h"
#include "files/sets.h"

namespace lacuna::files {
namespace {

struct Refused {
    std::string name;
    std::string file;
    std::string bytes;
    std::array<std::string, 3> told;
};

std::ostream& operator<<(std::ostream& out, const Refused& refused) {
    return out << refused.name;
}

class ARefusedFile : public testing::TestWithParam<Refused> {};

TEST_P(ARefusedFile, IsToldInOneLineThatNamesFilePlaceAndReason) {
    try {
        decode(GetParam().bytes, format_of(GetParam().file), "file");
        FAIL() << "was read";
    } catch (const FileError& error) {
        const std::string what = error.what();
        EXPECT_TRUE(what.starts_with("file:")) << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
        EXPECT_LT(what.size(), 200U) << what;
        for (const std::string& told : GetParam().told)
            EXPECT_NE(what.find(told), std::string::npos) << told << " in: " << what;
    }
}

std::string name_of_case(const testing::TestParamInfo<Refused>& info) {
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Lines, ARefusedFile,
    testing::ValuesIn(std::vector<Refused>{
        {"OneNumber", "a.txt", "0 1\n0.5\n", "file:2:", "\"0.5\"", "two finite"},
        {"ThreeNumbers", "a.txt", "0 1 2\n", "file:1:", "\"0 1 2\""},
        {"Words", "a.txt", "# x\n\nzero one\n", "file:3:", "zero one"},
        {"NaN", "a.txt", "0.5 nan\n", "file:1:", "nan", "finite"},
        {"Infinite", "a.txt", "-inf 1\n", "file:1:", "finite"},
        {"OverADouble", "a.txt", "1e999 1\n", "file:1:", "1e999"},
        {"TwoSigns", "a.txt", "+-1 1\n", "file:1:"},
        {"Commas", "a.txt", "0.5,0.5\n", "file:1:", "0.25 0.75"},
        {"Zeros", "a.txt", std::string(10, '\0'), "file:1:"},
        {"LongLine", "a.txt", std::string(100000, '7'), "file:1:", "..."},
        {"CsvHeaderTwice", "a.csv", "x,y\nx,y\n", "file:2:", "column \"x\" is \"x\""},
        {"CsvThreeColumns", "a.csv", "1,2,3\n", "file:1:", "3 columns", "one of them x"},
        {"CsvOtherNames", "a.csv", "id,left,up\n1,2,3\n", "file:1:", "columns are \"id,left,up\"",
         "called x"},
        {"CsvWithoutY", "a.csv", "x,z\n1,2\n", "file:1:", "called x"},
        {"CsvTwoOtherNames", "a.csv", "left,up\n1,2\n", "columns are \"left,up\"", "called x",
         "lon and lat, or easting and northing"},
        {"CsvMixedPair", "a.csv", "lon,northing\n1,2\n", "columns are \"lon,northing\""},
        {"CsvTwoPairs", "a.csv", "lon,lat,easting,northing\n1,2,3,4\n", "more than one pair"},
        {"CsvXTwice", "a.csv", "x,y,X\n1,2,3\n", "file:1:", "2 columns are called x"},
        {"CsvRagged", "a.csv", "id,x,y\n1,2,3\n1,2\n", "file:3:", "2 columns", "the header has 3"},
        {"CsvDecimalCommas", "a.csv", "x;y\n0,5;0,25\n", "file:2:", "column \"x\" is \"0,5\""},
        {"CsvOpenQuote", "a.csv", "x,y\n\"1,2\n", "file:2:", "quote"},
        {"CsvHeights", "a.csv", "x,y,z\n1,2,3\n1,3,4\n", "point 1 has z 4", "point 0 has 3"},
        {"CsvHeaderOfNaN", "a.csv", "nan,1\n", "file:1:"},
        {"CsvEmptyField", "a.csv", "x,y\n0.5,\n", "file:2:"},
        {"CsvBlanks", "a.csv", "x,y\n1 2\n", "file:2:"}}),
    name_of_case);

const std::string kTwoRows = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), }\n";

std::string npy_header(const std::string& descr, const std::string& shape) {
    return npy(1, "{'descr': " + descr + ", 'fortran_order': False, 'shape': " + shape + "}",
               doubles({1, 2, 3, 4}));
}

INSTANTIATE_TEST_SUITE_P(
    Npy, ARefusedFile,
    testing::ValuesIn(std::vector<Refused>{
        {"Empty", "a.npy", "", "not a .npy file"},
        {"OnlyMagic", "a.npy", "\x93NUMPY", "version"},
        {"Version4", "a.npy", npy(4, kTwoRows, ""), "4.0", "1.0, 2.0 or 3.0"},
        {"NoLength", "a.npy", std::string("\x93NUMPY\1\0\1", 9), "length"},
        {"HugeHeader", "a.npy", std::string("\x93NUMPY\2\0\xff\xff\xff\xff", 12), "4294967295",
         "10000"},
        {"CutHeader", "a.npy", std::string("\x93NUMPY\1\0\x50\0{", 11), "1 bytes of 80"},
        {"CutData", "a.npy", npy(1, kTwoRows, doubles({1, 2, 3})), "24 bytes"},
        {"CutNumber", "a.npy", npy(1, kTwoRows, doubles({1, 2, 3, 4}).substr(1)), "31 bytes"},
        {"MoreData", "a.npy", npy(1, kTwoRows, doubles({1, 2, 3, 4, 5})), "40 bytes"},
        {"NaN", "a.npy", npy(1, kTwoRows, doubles({1, 2, 3, std::nan("")})), "point 1", "nan",
         "finite"},
        {"NotADictionary", "a.npy", npy(1, "('descr')", ""), "descr"},
        {"NotEnded", "a.npy", npy(1, "{'descr': '<f8", ""), "header"},
        {"KeyTwice", "a.npy", npy(1, "{'descr': '<f8', 'descr': '<f8', 'shape': (0, 2)}", ""),
         "header"},
        {"KeyMissing", "a.npy", npy(1, "{'descr': '<f8'}", ""), "fortran_order"},
        {"Complex", "a.npy", npy_header("'<c8'", "(2, 2)"), "<c8", "f2 to f8"},
        {"Heights", "a.npy",
         npy(1, "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3)}",
             doubles({1, 2, 3, 4, 5, 6})),
         "point 1 has z 6", "point 0 has 3"},
        {"Records", "a.npy", npy_header("[('x', '<f8')]", "(2, 2)"), "header"},
        {"OneColumn", "a.npy", npy_header("'<f8'", "(4,)"), "(4,)", "N x 2"},
        {"FourColumns", "a.npy", npy_header("'<f8'", "(1, 4)"), "(1, 4)"},
        {"NegativeShape", "a.npy", npy_header("'<f8'", "(-2, 2)"), "header"},
        {"HugeShape", "a.npy", npy_header("'<f8'", "(18446744073709551615, 2)"),
         "18446744073709551615"},
        {"OverflowingShape", "a.npy", npy_header("'<f8'", "(1152921504606846978, 2)"),
         "1152921504606846978"}}),
    name_of_case);

std::string ply(const std::string& rest) {
    return "ply\nformat ascii 1.0\n" + rest;
}

const std::string kVertices = "element vertex 2\nproperty float x\nproperty float y\nend_header\n";

INSTANTIATE_TEST_SUITE_P(
    Ply, ARefusedFile,
    testing::ValuesIn(std::vector<Refused>{
        {"Empty", "a.ply", "", "not a .ply file"},
        {"OtherMagic", "a.ply", "plx\n", "not a .ply file"},
        {"NoEndOfHeader", "a.ply", ply("element vertex 2\n"), "end_header"},
        {"NoFormat", "a.ply", "ply\n" + kVertices, "format"},
        {"BigEndian", "a.ply", "ply\nformat binary_big_endian 1.0\n", "end_header"},
        {"OtherFormat", "a.ply", "ply\nformat binary 1.0\n", "file:2:", "\"binary\"",
         "binary_little_endian"},
        {"NoVertex", "a.ply", ply("end_header\n"), "no element vertex"},
        {"NoY", "a.ply", ply("element vertex 0\nproperty float x\nend_header\n"),
         "columns are \"x\"", "called x and y"},
        {"ListX", "a.ply",
         ply("element vertex 0\nproperty list uchar int x\nproperty float y\nend_header\n"),
         "columns are \"a list,y\""},
        {"Heights", "a.ply",
         ply("element vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
             "end_header\n1 2 3\n4 5 6\n"),
         "point 1 has z 6", "point 0 has 3"},
        {"FractionOfAClass", "a.ply",
         ply("element vertex 1\nproperty float x\nproperty float y\nproperty float class\n"
             "end_header\n1 2 0.5\n"),
         "point 0", "class", "whole number"},
        {"UnknownType", "a.ply", ply("element vertex 0\nproperty real x\n"), "file:4:", "real"},
        {"FloatLength", "a.ply", ply("element v 1\nproperty list float int x\n"),
         "file:4:", "integer"},
        {"BadCount", "a.ply", ply("element vertex -2\n"), "file:3:", "-2"},
        {"EarlyProperty", "a.ply", ply("property float x\n"), "file:3:"},
        {"CutLine", "a.ply", ply(kVertices + "1 2\n3\n"), "file:8:", "number"},
        {"CutLines", "a.ply", ply(kVertices + "1 2\n"), "vertex", "1 of 2"},
        {"LongLine", "a.ply", ply(kVertices + "1 2 3\n4 5 6\n"), "file:7:", "\"3\""},
        {"NaN", "a.ply", ply(kVertices + "1 2\nnan 3\n"), "point 1", "finite"},
        {"HugeCount", "a.ply",
         ply("element vertex 18446744073709551615\nproperty float x\nproperty float y\n"
             "end_header\n1 2\n"),
         "1 of 18446744073709551615"},
        {"HugeList", "a.ply",
         "ply\nformat binary_little_endian 1.0\nelement a 1\nproperty list uint int b\n"
         "end_header\n\xff\xff\xff\xff...",
         "element \"a\" 0"},
        {"NegativeList", "a.ply",
         "ply\nformat binary_little_endian 1.0\nelement a 1\nproperty list int int b\n"
         "end_header\n\xff\xff\xff\xff...",
         "length -1"},
        {"CutBinary", "a.ply",
         "ply\nformat binary_little_endian 1.0\n" + kVertices + floats({1, 2, 3}), "vertex",
         "1 of 2"}}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(Json, ARefusedFile,
                         testing::ValuesIn(std::vector<Refused>{
                             {"NoFeatures", "a.geojson", "[1]", "FeatureCollection"},
                             {"NoPoint", "a.geojson", R"({"features":[{"geometry":null}]})",
                              "feature 0", "two coordinates"},
                             {"Empty", "a.json", "", "JSON"},
                             {"Cut", "a.json", "[[1,2],[3,", "byte 11", "whole"},
                             {"NaN", "a.json", "[[1,NaN]]", "byte 5", "JSON"},
                             {"OverADouble", "a.json", "[[1,1e999]]", "too large"},
                             {"NotUtf8", "a.json", "[\"\xff\xfe\"]", "JSON"},
                             {"More", "a.json", "[[1,2]] [3]", "JSON"},
                             {"NoPoints", "a.json", R"({"width":1})", "no \"points\""},
                             {"PointsTwice", "a.json", R"({"points":[],"points":[]})", "twice"},
                             {"OneNumber", "a.json", "[[1,2],[3]]", "point 1", "1 number:"},
                             {"FourNumbers", "a.json", "[[1,2,3,4]]", "point 0", "4 numbers"},
                             {"TwoAndThree", "a.json", "[[1,2],[1,2,3]]", "point 1", "3 numbers"},
                             {"Heights", "a.json", "[[1,2,3],[1,3,4]]", "point 1 has z 4"},
                             {"FlatNumbers", "a.json", "[1,2]", "point 0", "[x, y]"},
                             {"Text", "a.json", R"([["1","2"]])", "point 0", "\"1\""},
                             {"Null", "a.json", "[[null,1]]", "point 0", "null"},
                             {"Objects", "a.json", R"([{"x":1,"y":2}])", "point 0", "an object"},
                             {"Scalar", "a.json", "7", "[x, y]"},
                             {"PointsOfNull", "a.json", R"({"points":null})", "null"},
                             {"OtherCount", "a.json", R"({"count":3,"points":[[1,2]]})", "1 point",
                              "3"},
                             {"Deep", "a.json", std::string(1000000, '['), "point 0", "an array"}}),
                         name_of_case);

TEST(AHostileFile, IsReadOrRefusedButNeverBreaksTheReader) {
    std::mt19937 random(1);
    for (const Format& format : readable()) {
        const std::string whole = encode({spread_points(20)}, format);
        for (int i = 0; i < 3000; ++i) {
            std::string bytes = whole.substr(0, random() % (whole.size() + 1));
            for (unsigned k = random() % 4; k > 0 && !bytes.empty(); --k)
                bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
            try {
                EXPECT_LE(decode(bytes, format, "file").points.size(), 100U);
            } catch (const FileError& error) {
                EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos)
                    << error.what();
            }
        }
    }
}

}  // namespace
}  // namespace lacuna::files
