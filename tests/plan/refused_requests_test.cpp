// Requests that only a program in C++ can make, and the line that refuses each. Those that options
// can make are in tests/refusals.txt.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "refusal.h"

namespace refused_requests_test {

using namespace lacuna;
using Names = std::vector<std::string>;
using Values = std::vector<double>;

TEST(Requests, ThatMakeNoSenseAreRefusedInOneLine) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const Mask five{3, 2, {1, 1, 1, 1, 1}}, closed{2, 2, {0, 0, 0, 0}};
    const Field even{2, 1, {1, 1}}, few{3, 2, {1}}, many{1, 1, {1, 1}}, none{0, 4, {}};
    const Field wraps{65536, 65536, {}};  // 2^32 pixels
    const Field endless{2, 1, {1, kInfinity}}, minus{1, 2, {1, -0.5}}, no_number{2, 1, {1, kNaN}};
    const Field zeros{2, 1, {0, -0.0}}, swirl{1, 1, {1}, {{4, 1}}}, of_one{2, 1, {1, 1}, {{2, 0}}};
    const Field wide{2, 1, {1, 1}, {{2, 0}, {0.5, 0}}}, turned{1, 1, {1}, {{2, kNaN}}};
    const std::vector<Point> two{{0.5, 0.5}, {0.6, 0.5}}, nowhere{{kNaN, 0}};
    const std::vector<std::uint8_t> of_two{0, 1}, strangers{0, 2};
    const Names ab{"a", "b"};
    const Values same(4, 0.1);
    const std::string size = " values: needs columns * rows values, at least one";
    const std::string importance = ": importance must be a finite number of at least 0";
    const std::string ratios =
        ": ratios must lie between 1 and 1000, angles between -1000 and 1000";
    const std::string each = ": must be one for each of the 2 classes";
    struct Case {
        std::string told;
        Request request;
    };
    const std::vector<Case> cases{
        {"mode 7: must be Mode::exact, lines, cells, stratified or pixels",
         {.radius = 0.1, .mode = static_cast<Mode>(7)}},
        {"boundary 2: must be Boundary::box or torus",
         {.domain = {.boundary = static_cast<Boundary>(2)}, .radius = 0.1}},
        {"metric -1: must be Metric::min, mean or max",
         {.radius = 0.1, .metric = static_cast<Metric>(-1)}},
        {"inside b: is no class of this set",
         {.radius = 0.1,
          .places = {.outlines = {{.polygons = {{two}}, .of_class = "b"}},
                     .border_by_radius = true}}},
        {"mask 3x2 with 5" + size, {.radius = 0.1, .places = {.mask = &five}}},
        {"accepted", {.radius = 0.1, .places = {.mask = &closed}}},
        {"count 10: points may lie nowhere in the domain, [0, 1) x [0, 1): must be a set without "
         "--count",
         {.count = 10, .places = {.mask = &closed}}},
        {"keep point 0 at (nan, 0): must lie in the domain, [0, 1] x [0, 1]",
         {.radius = 0.1, .keep = nowhere}},
        {"scale 0.5: is for a field", {.scale = 0.5}},
        {"field missing: mode cells needs one", {.mode = Mode::cells, .scale = 0.5}},
        {"field 3x2 with 1" + size, {.mode = Mode::cells, .field = &few, .scale = 0.1}},
        {"field 1x1 with 2" + size, {.field = &many, .scale = 0.1}},
        {"field 0x4 with 0" + size, {.field = &none, .scale = 0.1}},
        {"field 65536x65536 with 0" + size, {.field = &wraps, .scale = 0.1}},
        {"field inf at row 0, column 1" + importance, {.field = &endless, .scale = 0.1}},
        {"field -0.5 at row 1, column 0" + importance, {.field = &minus, .scale = 0.1}},
        {"field nan at row 0, column 1" + importance, {.field = &no_number, .scale = 0.1}},
        {"field of zeros: some importance must be greater than 0", {.field = &zeros, .scale = 0.1}},
        {"snap with mode cells: is for mode lines only",
         {.mode = Mode::cells, .field = &even, .scale = 0.1, .paper2011 = {.snap = true}}},
        {"stretches 0.5 at an angle of 0 at row 0, column 1" + ratios,
         {.field = &wide, .scale = 0.1}},
        {"stretches 2 at an angle of nan at row 0, column 0" + ratios,
         {.field = &turned, .scale = 0.1}},
        {"stretches 1 values: there must be one for each pixel of the field, 2",
         {.field = &of_one, .scale = 0.1}},
        {"stretches with mode cells: are for mode exact",
         {.mode = Mode::cells, .field = &swirl, .scale = 0.1}},
        {"on-pixels missing: mode pixels needs its pixels", {.count = 9, .mode = Mode::pixels}},
        {"on-pixels 9x9: is for mode pixels", {.count = 9, .on_pixels = Raster{9, 9}}},
        {"radius 2: is not for mode pixels, which takes --count",
         {.radius = 2, .mode = Mode::pixels, .on_pixels = Raster{9, 9}}},
        {"metric max: is not for mode stratified, which takes --count",
         {.count = 9, .mode = Mode::stratified, .metric = Metric::max}},
        {"border with mode stratified: is for mode exact only",
         {.count = 9, .mode = Mode::stratified, .places = {.border = 0.1}}},
        {"between 3 distances: must be a matrix of 2 x 2, for as many classes",
         {.classes = {.names = ab, .distances = {1, 2, 2}}}},
        {"class 1 weights" + each, {.classes = {.names = ab, .distances = same, .weights = {1}}}},
        {"class 1 numbers of points" + each,
         {.classes = {.names = ab, .distances = same, .counts = {1}}}},
        {"border 1 borders of classes" + each,
         {.places = {.borders = {0.1}}, .classes = {.names = ab, .distances = same}}},
        {"mask 1 masks of classes" + each,
         {.places = {.masks = {nullptr}}, .classes = {.names = ab, .distances = same}}},
        {"keep 2 points: with classes each needs a class, but 0 have one",
         {.classes = {.names = ab, .distances = same}, .keep = two}},
        {"keep class 2: must be less than 2, the number of classes",
         {.classes = {.names = ab, .distances = same}, .keep = two, .keep_classes = strangers}},
        {"keep classes of points: are for requests with classes",
         {.radius = 0.01, .keep = two, .keep_classes = of_two}}};
    for (const Case& one : cases)
        EXPECT_EQ(tests::refusal_of([&] { sample(one.request); }), one.told);
}

}  // namespace refused_requests_test
