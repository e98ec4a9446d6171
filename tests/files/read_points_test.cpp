// Point files: points are read back to the last bit, and errors take one line.
#include "files/read_points.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "files/point_files.h"
#include "files/read_points_bytes.h"
#include "files/sets.h"
#include "folder.h"

namespace lacuna::files {
namespace read_points_test {

using Points = std::vector<Point>;

// Unlike ==, distinguishes 0 from -0.
void expect_same_bits(const Points& read, const Points& written) {
    ASSERT_EQ(read.size(), written.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        EXPECT_EQ(std::bit_cast<std::uint64_t>(read[i].x),
                  std::bit_cast<std::uint64_t>(written[i].x))
            << i;
        EXPECT_EQ(std::bit_cast<std::uint64_t>(read[i].y),
                  std::bit_cast<std::uint64_t>(written[i].y))
            << i;
    }
}

TEST(APointFile, OfEveryReadableFormatGivesBackWhatWasEncoded) {
    for (const Format& format : readable()) {
        for (const Points& points :
             {Points{}, Points{{0.25, 0.7}}, awkward_points(), spread_points(5000)})
            expect_same_bits(decode(encode({points}, format), format, "file").points, points);
    }
}

TEST(APointFile, IsReadByItsExtensionAndErrorsNameIt) {
    const tests::Folder folder;
    const Points points = spread_points(10);
    for (const char* name : {"a.txt", "a.csv", "a.npy", "a.ply", "a.geojson", "a.json", "A.TXT"}) {
        const std::string path = folder.path(name);
        write_whole(path, encode({points}, format_of(path)));
        expect_same_bits(read_points(path).points, points);
    }
    std::filesystem::create_directory(folder.path("folder.txt"));
    for (const char* name :
         {"missing.txt", "folder.txt", "a.svg", "a.pdf", "a.png", "a.xyz", "a"}) {
        const std::string path = folder.path(name);
        try {
            read_points(path);
            ADD_FAILURE() << name << " was read";
        } catch (const FileError& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with(path + ": ")) << error.what();
        }
    }
}

TEST(ATextFile, MayHaveCommentsBlankLinesTabsPlusesAndNoLastLineEnd) {
    const Points expected{{0.5, 0.25}, {1e-3, -2}};
    for (const char* text : {"0.5 0.25\n1e-3 -2\n", "# x y\n\n0.5\t0.25 \r\n\r\n  +1e-3   -2",
                             "\xef\xbb\xbf"
                             "0.5 0.25\n  # two\n1E-03 -2.0\n"})
        expect_same_bits(decode(text, format_of("a.txt"), "file").points, expected);
}

TEST(ACsvFile, MayHaveAHeaderBlanksAndComments) {
    const Points expected{{0.5, 0.25}, {1e-3, -2}};
    for (const char* text : {"x,y\n0.5,0.25\n1e-3,-2\n", "\"x\", \"y\"\r\n0.5 , 0.25\r\n1e-3, -2",
                             "# made by hand\nlongitude,latitude\n\n0.5,0.25\n1e-3,-2\n",
                             "\xef\xbb\xbfx,y\n0.5,0.25\n1e-3,-2\n", "0.5,0.25\n1e-3,-2\n"})
        expect_same_bits(decode(text, format_of("a.csv"), "file").points, expected);
}

TEST(AnNpyFile, MayBeOfAnyVersionOrderAndFloatSize) {
    const Points expected{{1, 2}, {3, 4}, {5, 6}};
    const std::string rows = "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 2), }   \n";
    for (const int major : {1, 2, 3})
        expect_same_bits(
            decode(npy(major, rows, doubles({1, 2, 3, 4, 5, 6})), format_of("a.npy"), "file")
                .points,
            expected);
    const std::string columns = "{\"shape\":(3L,2L),\"fortran_order\":True,\"descr\":\"<f4\"}";
    expect_same_bits(
        decode(npy(1, columns, floats({1, 3, 5, 2, 4, 6})), format_of("a.npy"), "file").points,
        expected);
}

TEST(APlyFile, MayBeBinaryWithOtherPropertiesListsAndElements) {
    const std::string header =
        "ply\r\nformat binary_little_endian 1.0\r\ncomment by hand\r\n"
        "element camera 2\r\nproperty list uchar short a\r\nproperty uint b\r\n"
        "element nothing 1000000000000000000\r\n"
        "element vertex 2\r\nproperty uchar red\r\nproperty float y\r\n"
        "property list int double weights\r\nproperty double x\r\nend_header\r\n";
    const std::string cameras = std::string("\x02zzzz", 5) + "bbbb" + std::string("\0", 1) + "bbbb";
    const std::string first =
        floats({0.25F}).insert(0, 1, 'r') + std::string("\1\0\0\0", 4) + doubles({9, 0.5});
    const std::string second =
        floats({-2}).insert(0, 1, 'r') + std::string(4, '\0') + doubles({1e-3});
    expect_same_bits(
        decode(header + cameras + first + second + "more", format_of("a.ply"), "file").points,
        {{0.5, 0.25}, {1e-3, -2}});
}

TEST(APlyFile, MayBeTextWithOtherPropertiesListsAndElements) {
    const std::string text =
        "ply\nformat ascii 1.0\nobj_info of ours\nelement camera 1\nproperty list uchar int a\n"
        "element vertex 2\nproperty float32 x\nproperty list uchar int a\nproperty float64 y\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "3 1 2 3\n0.5 2 7 7 0.25\n1e-3 0 -2 \n3 0 1 0\n";
    expect_same_bits(decode(text, format_of("a.ply"), "file").points, {{0.5, 0.25}, {1e-3, -2}});
}

TEST(AJsonFile, MayBeABareArrayOrAnObjectWithOtherKeys) {
    const Points expected{{0.5, 0.25}, {1e-3, -2}};
    for (const char* text :
         {"[[0.5,0.25],[1e-3,-2]]", R"({"points":[[0.5,0.25],[1e-3,-2]]})",
          R"({"a":{"points":[[7]]},"b":[[1,2,[3]],null],"points":[[0.5,0.25],[0.001,-2]],"c":"d"})",
          R"({"count":2,"points":[[0.5,0.25],[1e-3,-2]]})"})
        expect_same_bits(decode(text, format_of("a.json"), "file").points, expected);
}

}  // namespace read_points_test
}  // namespace lacuna::files
