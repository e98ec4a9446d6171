// Given a point file with something wrong in it, the reader says what and where in one line.
#include <gtest/gtest.h>

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
    Format format;
    std::string bytes;
    std::vector<std::string> told;
};

std::ostream& operator<<(std::ostream& out, const Refused& refused) {
    return out << refused.name;
}

class ARefusedFile : public testing::TestWithParam<Refused> {};

TEST_P(ARefusedFile, IsToldInOneLineThatNamesFilePlaceAndReason) {
    try {
        decode(GetParam().bytes, GetParam().format, "file");
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
    testing::Values(
        Refused{
            "OneNumber", format_of("a.txt"), "0 1\n0.5\n", {"file:2:", "\"0.5\"", "two finite"}},
        Refused{"ThreeNumbers", format_of("a.txt"), "0 1 2\n", {"file:1:", "\"0 1 2\""}},
        Refused{"Words", format_of("a.txt"), "# x\n\nzero one\n", {"file:3:", "zero one"}},
        Refused{"NaN", format_of("a.txt"), "0.5 nan\n", {"file:1:", "nan", "finite"}},
        Refused{"Infinite", format_of("a.txt"), "-inf 1\n", {"file:1:", "finite"}},
        Refused{"OverADouble", format_of("a.txt"), "1e999 1\n", {"file:1:", "1e999"}},
        Refused{"TwoSigns", format_of("a.txt"), "+-1 1\n", {"file:1:"}},
        Refused{"Commas", format_of("a.txt"), "0.5,0.5\n", {"file:1:", "0.25 0.75"}},
        Refused{"Zeros", format_of("a.txt"), std::string(10, '\0'), {"file:1:"}},
        Refused{"LongLine", format_of("a.txt"), std::string(100000, '7'), {"file:1:", "..."}},
        Refused{"CsvHeaderTwice", format_of("a.csv"), "x,y\nx,y\n", {"file:2:", "0.25,0.75"}},
        Refused{"CsvThreeColumns", format_of("a.csv"), "x,y,z\n1,2,3\n", {"file:2:"}},
        Refused{"CsvHeaderOfNaN", format_of("a.csv"), "nan,1\n", {"file:1:"}},
        Refused{"CsvEmptyField", format_of("a.csv"), "x,y\n0.5,\n", {"file:2:"}},
        Refused{"CsvBlanks", format_of("a.csv"), "x,y\n1 2\n", {"file:2:"}}),
    name_of_case);

const std::string kTwoRows = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), }\n";

std::string npy_header(const std::string& descr, const std::string& shape) {
    return npy(1, "{'descr': " + descr + ", 'fortran_order': False, 'shape': " + shape + "}",
               doubles({1, 2, 3, 4}));
}

INSTANTIATE_TEST_SUITE_P(
    Npy, ARefusedFile,
    testing::Values(
        Refused{"Empty", format_of("a.npy"), "", {"not a .npy file"}},
        Refused{"OnlyMagic", format_of("a.npy"), "\x93NUMPY", {"version"}},
        Refused{"Version4", format_of("a.npy"), npy(4, kTwoRows, ""), {"4.0", "1.0, 2.0 or 3.0"}},
        Refused{"NoLength", format_of("a.npy"), std::string("\x93NUMPY\1\0\1", 9), {"length"}},
        Refused{"HugeHeader",
                format_of("a.npy"),
                std::string("\x93NUMPY\2\0\xff\xff\xff\xff", 12),
                {"4294967295", "10000"}},
        Refused{"CutHeader",
                format_of("a.npy"),
                std::string("\x93NUMPY\1\0\x50\0{", 11),
                {"1 bytes of 80"}},
        Refused{"CutData", format_of("a.npy"), npy(1, kTwoRows, doubles({1, 2, 3})), {"24 bytes"}},
        Refused{"CutNumber",
                format_of("a.npy"),
                npy(1, kTwoRows, doubles({1, 2, 3, 4}).substr(1)),
                {"31 bytes"}},
        Refused{"MoreData",
                format_of("a.npy"),
                npy(1, kTwoRows, doubles({1, 2, 3, 4, 5})),
                {"40 bytes"}},
        Refused{"NaN",
                format_of("a.npy"),
                npy(1, kTwoRows, doubles({1, 2, 3, std::nan("")})),
                {"point 1", "nan", "finite"}},
        Refused{"NotADictionary", format_of("a.npy"), npy(1, "('descr')", ""), {"descr"}},
        Refused{"NotEnded", format_of("a.npy"), npy(1, "{'descr': '<f8", ""), {"header"}},
        Refused{"KeyTwice",
                format_of("a.npy"),
                npy(1, "{'descr': '<f8', 'descr': '<f8', 'shape': (0, 2)}", ""),
                {"header"}},
        Refused{
            "KeyMissing", format_of("a.npy"), npy(1, "{'descr': '<f8'}", ""), {"fortran_order"}},
        Refused{"BigEndian",
                format_of("a.npy"),
                npy_header("'>f8'", "(2, 2)"),
                {">f8", "little-endian"}},
        Refused{"Integers", format_of("a.npy"), npy_header("'<i8'", "(2, 2)"), {"<i8"}},
        Refused{"Records", format_of("a.npy"), npy_header("[('x', '<f8')]", "(2, 2)"), {"header"}},
        Refused{"OneColumn", format_of("a.npy"), npy_header("'<f8'", "(4,)"), {"(4,)", "N x 2"}},
        Refused{"ThreeColumns", format_of("a.npy"), npy_header("'<f8'", "(2, 3)"), {"(2, 3)"}},
        Refused{"NegativeShape", format_of("a.npy"), npy_header("'<f8'", "(-2, 2)"), {"header"}},
        Refused{"HugeShape",
                format_of("a.npy"),
                npy_header("'<f8'", "(18446744073709551615, 2)"),
                {"18446744073709551615"}},
        Refused{"OverflowingShape",
                format_of("a.npy"),
                npy_header("'<f8'", "(1152921504606846978, 2)"),
                {"1152921504606846978"}}),
    name_of_case);

std::string ply(const std::string& rest) {
    return "ply\nformat ascii 1.0\n" + rest;
}

const std::string kVertices = "element vertex 2\nproperty float x\nproperty float y\nend_header\n";

INSTANTIATE_TEST_SUITE_P(
    Ply, ARefusedFile,
    testing::Values(
        Refused{"Empty", format_of("a.ply"), "", {"not a .ply file"}},
        Refused{"OtherMagic", format_of("a.ply"), "plx\n", {"not a .ply file"}},
        Refused{"NoEndOfHeader", format_of("a.ply"), ply("element vertex 2\n"), {"end_header"}},
        Refused{"NoFormat", format_of("a.ply"), "ply\n" + kVertices, {"format"}},
        Refused{"BigEndian",
                format_of("a.ply"),
                "ply\nformat binary_big_endian 1.0\n",
                {"file:2:", "binary_big_endian", "binary_little_endian"}},
        Refused{"NoVertex", format_of("a.ply"), ply("end_header\n"), {"no element vertex"}},
        Refused{"NoY",
                format_of("a.ply"),
                ply("element vertex 0\nproperty float x\nend_header\n"),
                {"must have y"}},
        Refused{"IntegerX",
                format_of("a.ply"),
                ply("element vertex 0\nproperty int x\nproperty float y\nend_header\n"),
                {"must have x", "float"}},
        Refused{"UnknownType",
                format_of("a.ply"),
                ply("element vertex 0\nproperty real x\n"),
                {"file:4:", "real"}},
        Refused{"FloatLength",
                format_of("a.ply"),
                ply("element v 1\nproperty list float int x\n"),
                {"file:4:", "integer"}},
        Refused{"BadCount", format_of("a.ply"), ply("element vertex -2\n"), {"file:3:", "-2"}},
        Refused{"EarlyProperty", format_of("a.ply"), ply("property float x\n"), {"file:3:"}},
        Refused{"CutLine", format_of("a.ply"), ply(kVertices + "1 2\n3\n"), {"file:8:", "number"}},
        Refused{"CutLines", format_of("a.ply"), ply(kVertices + "1 2\n"), {"vertex", "1 of 2"}},
        Refused{"LongLine",
                format_of("a.ply"),
                ply(kVertices + "1 2 3\n4 5 6\n"),
                {"file:7:", "\"3\""}},
        Refused{"NaN", format_of("a.ply"), ply(kVertices + "1 2\nnan 3\n"), {"point 1", "finite"}},
        Refused{"HugeCount",
                format_of("a.ply"),
                ply("element vertex 18446744073709551615\nproperty float x\nproperty float y\n"
                    "end_header\n1 2\n"),
                {"1 of 18446744073709551615"}},
        Refused{"HugeList",
                format_of("a.ply"),
                "ply\nformat binary_little_endian 1.0\nelement a 1\nproperty list uint int b\n"
                "end_header\n\xff\xff\xff\xff...",
                {"element \"a\" 0"}},
        Refused{"NegativeList",
                format_of("a.ply"),
                "ply\nformat binary_little_endian 1.0\nelement a 1\nproperty list int int b\n"
                "end_header\n\xff\xff\xff\xff...",
                {"length -1"}},
        Refused{"CutBinary",
                format_of("a.ply"),
                "ply\nformat binary_little_endian 1.0\n" + kVertices + floats({1, 2, 3}),
                {"vertex", "1 of 2"}}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Json, ARefusedFile,
    testing::Values(
        Refused{"Empty", format_of("a.json"), "", {"JSON"}},
        Refused{"Cut", format_of("a.json"), "[[1,2],[3,", {"byte 11", "whole"}},
        Refused{"NaN", format_of("a.json"), "[[1,NaN]]", {"byte 5", "JSON"}},
        Refused{"OverADouble", format_of("a.json"), "[[1,1e999]]", {"1e999"}},
        Refused{"NotUtf8", format_of("a.json"), "[\"\xff\xfe\"]", {"JSON"}},
        Refused{"More", format_of("a.json"), "[[1,2]] [3]", {"JSON"}},
        Refused{"NoPoints", format_of("a.json"), R"({"width":1})", {"no \"points\""}},
        Refused{"PointsTwice", format_of("a.json"), R"({"points":[],"points":[]})", {"twice"}},
        Refused{"OneNumber", format_of("a.json"), "[[1,2],[3]]", {"point 1", "1 number:"}},
        Refused{"ThreeNumbers", format_of("a.json"), "[[1,2,3]]", {"point 0", "3 numbers"}},
        Refused{"FlatNumbers", format_of("a.json"), "[1,2]", {"point 0", "[x, y]"}},
        Refused{"Text", format_of("a.json"), R"([["1","2"]])", {"point 0", "\"1\""}},
        Refused{"Null", format_of("a.json"), "[[null,1]]", {"point 0", "null"}},
        Refused{"Objects", format_of("a.json"), R"([{"x":1,"y":2}])", {"point 0", "an object"}},
        Refused{"Scalar", format_of("a.json"), "7", {"[x, y]"}},
        Refused{"PointsOfNull", format_of("a.json"), R"({"points":null})", {"null"}},
        Refused{
            "OtherCount", format_of("a.json"), R"({"count":3,"points":[[1,2]]})", {"1 point", "3"}},
        Refused{"Deep", format_of("a.json"), std::string(1000000, '['), {"point 0", "an array"}}),
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
                EXPECT_LE(decode(bytes, format, "file").size(), 100U);
            } catch (const FileError& error) {
                EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos)
                    << error.what();
            }
        }
    }
}

}  // namespace
}  // namespace lacuna::files
