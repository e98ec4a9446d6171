// Text and array formats: points read back equal the points written, to the last bit.
#include <gtest/gtest.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "files/point_files.h"
#include "files/sets.h"

namespace lacuna::files {
namespace {

PointSet set_of(const std::vector<Point>& points) {
    return {points, {2.0, 1.5}, 0.1};
}

std::vector<std::string> lines_of(const std::string& bytes) {
    std::vector<std::string> lines;
    std::istringstream stream(bytes);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

// The point of a line "x SEPARATOR y END".
Point parse(const std::string& line, char separator, std::string_view end) {
    char* after_x = nullptr;
    char* after_y = nullptr;
    const double x = std::strtod(line.c_str(), &after_x);
    EXPECT_EQ(*after_x, separator) << line;
    const double y = std::strtod(after_x + 1, &after_y);
    EXPECT_EQ(std::string_view(after_y), end) << line;
    return {x, y};
}

// Unlike ==, distinguishes 0 from -0.
void expect_same_bits(const std::vector<Point>& read, const std::vector<Point>& written) {
    ASSERT_EQ(read.size(), written.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        EXPECT_EQ(std::bit_cast<std::uint64_t>(read[i].x),
                  std::bit_cast<std::uint64_t>(written[i].x))
            << "x of point " << i << ": " << read[i].x;
        EXPECT_EQ(std::bit_cast<std::uint64_t>(read[i].y),
                  std::bit_cast<std::uint64_t>(written[i].y))
            << "y of point " << i << ": " << read[i].y;
    }
}

void expect_text_round_trip(const std::vector<Point>& points, const Format& format,
                            const std::vector<std::string>& header, char separator,
                            std::string_view end) {
    const std::string bytes = encode(set_of(points), format);
    EXPECT_TRUE(bytes.empty() || bytes.back() == '\n');
    std::vector<std::string> lines = lines_of(bytes);
    ASSERT_EQ(lines.size(), header.size() + points.size());
    std::vector<Point> read;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (i < header.size()) {
            EXPECT_EQ(lines[i], header[i]);
        } else {
            read.push_back(parse(lines[i], separator, end));
        }
    }
    expect_same_bits(read, points);
}

std::vector<std::string> ply_header(std::size_t count) {
    return {"ply",
            "format ascii 1.0",
            "element vertex " + std::to_string(count),
            "property double x",
            "property double y",
            "property double z",
            "end_header"};
}

// The header that NumPy's own format description asks for, then the data.
void expect_npy_round_trip(const std::vector<Point>& points) {
    const std::string bytes = encode(set_of(points), format_of("a.npy"));
    ASSERT_GE(bytes.size(), 10U);
    EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    const auto byte_at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    const std::size_t data = 10U + byte_at(8) + 256U * byte_at(9);
    EXPECT_EQ(data % 64, 0U);
    ASSERT_EQ(bytes.size(), data + 16 * points.size());

    const std::string text = "{'descr': '<f8', 'fortran_order': False, 'shape': (" +
                             std::to_string(points.size()) + ", 2), }";
    EXPECT_EQ(bytes.substr(10, text.size()), text);
    EXPECT_EQ(bytes.substr(10 + text.size(), data - 10 - text.size()),
              std::string(data - 11 - text.size(), ' ') + "\n");

    std::vector<Point> read(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::uint64_t x = 0;
        std::uint64_t y = 0;
        for (std::size_t b = 0; b < 8; ++b) {
            x |= std::uint64_t{byte_at(data + 16 * i + b)} << (8 * b);
            y |= std::uint64_t{byte_at(data + 16 * i + 8 + b)} << (8 * b);
        }
        read[i] = {std::bit_cast<double>(x), std::bit_cast<double>(y)};
    }
    expect_same_bits(read, points);
}

void expect_json_round_trip(const std::vector<Point>& points) {
    const nlohmann::json json = nlohmann::json::parse(encode(set_of(points), format_of("a.json")));
    EXPECT_EQ(json.at("width").get<double>(), 2.0);
    EXPECT_EQ(json.at("height").get<double>(), 1.5);
    EXPECT_EQ(json.at("radius").get<double>(), 0.1);
    EXPECT_EQ(json.at("count").get<std::size_t>(), points.size());
    EXPECT_EQ(json.at("boundary"), "box");
    EXPECT_EQ(json.size(), 6U);
    std::vector<Point> read;
    for (const nlohmann::json& point : json.at("points")) {
        ASSERT_EQ(point.size(), 2U);
        EXPECT_TRUE(point[0].is_number_float()) << point;
        read.push_back({point[0].get<double>(), point[1].get<double>()});
    }
    expect_same_bits(read, points);
}

struct NamedPoints {
    const char* name;
    std::vector<Point> points;
    friend std::ostream& operator<<(std::ostream& stream, const NamedPoints& named) {
        return stream << named.name;
    }
};

class PointFiles : public testing::TestWithParam<NamedPoints> {};

TEST_P(PointFiles, OfEveryFormatGiveTheSameDoubles) {
    const std::vector<Point>& points = GetParam().points;
    expect_text_round_trip(points, format_of("a.txt"), {}, ' ', "");
    expect_text_round_trip(points, format_of("a.csv"), {"x,y"}, ',', "");
    expect_text_round_trip(points, format_of("a.ply"), ply_header(points.size()), ' ', " 0");
    expect_npy_round_trip(points);
    expect_json_round_trip(points);
}

INSTANTIATE_TEST_SUITE_P(Sets, PointFiles,
                         testing::Values(NamedPoints{"Empty", {}},
                                         NamedPoints{"OnePoint", {{0.25, 0.7}}},
                                         NamedPoints{"AwkwardPoints", awkward_points()},
                                         NamedPoints{"ManyPoints", spread_points(10000)}),
                         [](const testing::TestParamInfo<NamedPoints>& set) {
                             return std::string(set.param.name);
                         });

TEST(PointFile, GivenTxtThenALineHolds17SignificantDigits) {
    const std::vector<Point> points = {{0.1, 0.5}};
    EXPECT_EQ(encode(set_of(points), format_of("a.txt")), "0.10000000000000001 0.5\n");
}

TEST(PointFile, GivenAHeaderOfEveryLengthThenNpyDataIsAlignedTo64Bytes) {
    for (const std::size_t count : {9U, 99U, 999U, 99999U}) {
        const std::vector<Point> points(count, Point{0.5, 0.5});
        EXPECT_EQ(encode(set_of(points), format_of("a.npy")).size() % 64, count * 16 % 64) << count;
    }
}

}  // namespace
}  // namespace lacuna::files
