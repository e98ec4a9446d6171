// Files of other programs: columns are found by their names, whatever stands between them, and a
// third coordinate may be there if it is the same everywhere.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "files/point_files.h"
#include "files/read_points.h"
#include "files/read_points_bytes.h"

namespace lacuna::files {
namespace read_columns_test {

using Points = std::vector<Point>;

const Points kTwo{{1, 2}, {3, 4}};

Points read(const std::string& name, const std::string& bytes) {
    return decode(bytes, format_of(name), "file").points;
}

PointsOfFile set_in(const std::string& name, const std::string& bytes) {
    return decode(bytes, format_of(name), "file");
}

TEST(ACsvFile, IsReadByTheNamesOfItsColumns) {
    for (const char* text : {
             "id,x,y\na,1,2\nb,3,4\n",                    // an id first
             "id,x,y\ninfinity,1,2\nnan,3,4\n",           // whose texts may look like numbers
             ",x,y\n0,1,2\n1,3,4\n",                      // the index of pandas
             "\"\",\"x\",\"y\"\n\"1\",1,2\n\"2\",3,4\n",  // the row names of R's write.csv
             "\"x\",\"y\"\n\"1\",1,2\n\"2\",3,4\n",       // and of its write.table
             "x;y\n1;2\n3;4\n",                           // a spreadsheet's semicolons
             "id;y;x\n7;2;1\n8;4;3\n",
             "x\ty\n1\t2\n3\t4\n",
             "\tx\ty\n\t1\t2\n\t3\t4\n",
             "X,Y\n1,2\n3,4\n",
             "y,x\n2,1\n4,3\n",
             "info,x,name,y\n5,1,\"a, \"\"b\"\"\",2\n6,3,c,4\n",
             "x,y,z\n1,2,9\n3,4,9\n",
             "lon,lat\n1,2\n3,4\n",
             "lat,lon\n2,1\n4,3\n",
             "Latitude;id;Longitude\n2;9;1\n4;9;3\n",
             "latitude,lon\n2,1\n4,3\n",
             "northing,easting\n2,1\n4,3\n",
             "lat,lon,y,x\n8,9,2,1\n8,9,4,3\n",  // x and y come before others
         })
        EXPECT_EQ(read("a.csv", text), kTwo) << text;
}

TEST(ACsvFile, TellsWhichColumnsWereNotRead) {
    EXPECT_EQ(set_in("a.csv", "id,x,y,class,z,a,b\nq,1,2,tree,0,1,1\n").other_columns,
              (std::vector<std::string>{"id", "a", "b"}));
    EXPECT_TRUE(set_in("a.csv", "x,y,a,b,angle,ink\n1,2,1,1,0,red\n").other_columns.empty());
}

// The bytes of numbers of any type in either order.
template <class Number>
std::string bytes_of(const std::vector<double>& values, std::endian order) {
    std::string bytes;
    for (const double value : values) {
        const auto number = static_cast<Number>(value);
        std::string one(reinterpret_cast<const char*>(&number), sizeof(Number));
        if (order != std::endian::native) one.assign(one.rbegin(), one.rend());
        bytes += one;
    }
    return bytes;
}

template <class Number>
void expect_read_in_both_orders(const std::string& type) {
    for (const auto& [sign, order] : {std::pair{"<", std::endian::little}, {">", std::endian::big}})
        for (const bool is_fortran : {false, true}) {
            const std::string descr = sizeof(Number) == 1 ? "|" + type : sign + type;
            const std::string header = "{'descr': '" + descr +
                                       "', 'fortran_order': " + (is_fortran ? "True" : "False") +
                                       ", 'shape': (2, 2)}";
            const std::vector<double> values =
                is_fortran ? std::vector<double>{1, 3, 2, 4} : std::vector<double>{1, 2, 3, 4};
            EXPECT_EQ(read("a.npy", npy(1, header, bytes_of<Number>(values, order))), kTwo)
                << header;
        }
}

TEST(AnNpyFile, MayHoldNumbersOfAnyTypeInEitherByteOrder) {
    expect_read_in_both_orders<double>("f8");
    expect_read_in_both_orders<float>("f4");
    expect_read_in_both_orders<std::int8_t>("i1");
    expect_read_in_both_orders<std::int16_t>("i2");
    expect_read_in_both_orders<std::int32_t>("i4");
    expect_read_in_both_orders<std::int64_t>("i8");
    expect_read_in_both_orders<std::uint16_t>("u2");
    expect_read_in_both_orders<std::uint64_t>("u8");
    const std::string halves("\x00\x3c\x00\x40\x00\x42\x00\x44", 8);  // 1 2 3 4
    EXPECT_EQ(
        read("a.npy", npy(1, "{'descr': '<f2', 'fortran_order': False, 'shape': (2, 2)}", halves)),
        kTwo);
}

TEST(AThirdCoordinate, ThatIsTheSameEverywhereIsDropped) {
    EXPECT_EQ(read("a.npy", npy(1, "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3)}",
                                doubles({1, 2, 9, 3, 4, 9}))),
              kTwo);
    EXPECT_EQ(read("a.json", "[[1,2,9],[3,4,9]]"), kTwo);
    EXPECT_EQ(read("a.ply",
                   "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                   "property float y\nproperty float z\nend_header\n1 2 9\n3 4 9\n"),
              kTwo);
}

TEST(APlyFile, MayBeBigEndianAndOfWholeNumbers) {
    const std::string header =
        "ply\nformat binary_big_endian 1.0\nelement vertex 2\nproperty int y\n"
        "property double x\nend_header\n";
    std::string rows;
    for (const Point& point : kTwo)
        rows += bytes_of<std::int32_t>({point.y}, std::endian::big) +
                bytes_of<double>({point.x}, std::endian::big);
    EXPECT_EQ(read("a.ply", header + rows), kTwo);
}

}  // namespace read_columns_test
}  // namespace lacuna::files
