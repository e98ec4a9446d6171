// The options of sample and stipple arrive in the library: the command makes the set that the
// library makes of the same request.
#include <gtest/gtest.h>
#include <lacuna/domains.h>
#include <lacuna/stipple.h>

#include <cstdint>
#include <deque>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "cli/expectations.h"
#include "cli/pictures.h"
#include "files/read_points.h"
#include "pictures/ellipses.h"
#include "program.h"

namespace arrives_test {

using namespace lacuna;
using namespace lacuna::tests;

std::vector<Point> points_by(const Folder& folder, const Words& command, const Words& options) {
    expect_success(joined(joined(command, options), {"--quiet", "-o", folder.path("made.csv")}));
    return files::read_points(folder.path("made.csv")).points;
}

// Lighter to the right, 24 x 16 pixels.
std::string gradient(const Folder& folder) {
    std::string pixels;
    for (int row = 0; row < 16; ++row)
        for (int column = 0; column < 24; ++column)
            pixels += static_cast<char>(column * 11 + row / 4);
    return grey_picture(folder, 24, 16, pixels);
}

// Options of sample, and the request that they must become.
struct Arrival {
    Words words;
    Request request;
};

// Whatever requests refer to, beside files of the same content.
class OptionsOfSample : public testing::Test {
protected:
    std::string file(const char* name, const std::string& content) const {
        write_file(folder_.path(name), content);
        return folder_.path(name);
    }
    std::string square(const char* name, const std::string& low, const std::string& high) const {
        return file(name, low + " " + low + "\n" + high + " " + low + "\n" + high + " " + high +
                              "\n" + low + " " + high + "\n");
    }
    static std::vector<PolygonRing> ring(double from, double to) {
        return {{{from, from}, {to, from}, {to, to}, {from, to}}};
    }
    // A mask that is drawn from polygons, on the unit square and at an edge of 0.003.
    const Mask* drawn(const std::vector<PolygonSet>& sets) {
        return &masks_.emplace_back(draw_places(sets, {1, 1}, 0.003));
    }
    void expect_arrivals(const std::vector<Arrival>& arrivals) const {
        for (const Arrival& one : arrivals) {
            SCOPED_TRACE(testing::PrintToString(one.words));
            const std::string made = folder_.path("made.json");
            expect_success(joined(joined({"sample"}, one.words), {"--quiet", "-o", made}));
            const files::PointsOfFile got = files::read_points(made);
            const Result expected = sample(one.request);
            EXPECT_EQ(got.points, expected.points);
            EXPECT_EQ(got.classes.of_point, expected.classes);
        }
    }

    const Folder folder_;
    std::deque<Mask> masks_;
};

TEST_F(OptionsOfSample, ThatNamePicturesAndPointsArriveInTheRequest) {
    const std::string mask = grey_picture(folder_, 2, 1, bytes({0, 255}));
    const std::string keep = file("keep.csv", "x,y\n0.75,0.30000000000000004\n");
    const std::string west = file("west.csv", "x,y\n0.98,0.3\n0.5,0.5\n0.97,0.6\n");
    const Folder other;
    const std::string picture = gradient(other);
    const Mask allowed{2, 1, {0, 1}};
    const std::vector<Point> kept{{0.75, 0.30000000000000004}},
        beside{{.98, .3}, {.5, .5}, {.97, .6}};
    const Field field = importance_of(read_picture(picture), {.invert = true, .gamma = 1.7});
    Request of_field{
        .domain = {.height = 2.0 / 3, .boundary = Boundary::torus}, .count = 300, .seed = 5};
    of_field.field = &field;
    const Field along = importance_of(read_picture(picture), {.along = 4});
    const Field one =
        pictures::field_of(1, 1, std::vector{Ellipse{0.05, 0.01, 30 * std::numbers::pi / 180}});
    Request of_along{.domain = {.height = 2.0 / 3}, .scale = 0.03},
        of_stretch{.domain = {.boundary = Boundary::torus}, .scale = 1};
    of_along.field = &along;
    of_stretch.field = &one;
    expect_arrivals({{{"--mask", mask, "--border", "0.02", "--keep", keep, "--radius", "0.05"},
                      {.domain = {.height = 0.5},
                       .radius = 0.05,
                       .places = {.mask = &allowed, .border = 0.02},
                       .keep = kept}},
                     {{"--field", picture, "--count", "300", "--invert", "--gamma", "1.7",
                       "--torus", "--seed", "5"},
                      of_field},
                     {{"--field", picture, "--scale", "0.03", "--along", "4"}, of_along},
                     {{"--stretch", "0.05:0.01@30", "--torus"}, of_stretch},
                     {{"--keep", west, "--domain", "1,0+1x1", "--radius", "0.04"},
                      {.domain = {.x0 = 1}, .radius = 0.04, .keep = beside}}});
}

TEST_F(OptionsOfSample, ThatNamePlacesArriveInTheRequest) {
    const std::string low = square("low.txt", "0", "0.6"), high = square("high.txt", "0.4", "1"),
                      pond = square("pond.txt", "0.3", "0.45"),
                      rocks = file("rocks.csv", "radius,x,y\n0.1,0.7,0.7\n"),
                      road = file("road.txt", "0.1 0.5\n0.9 0.6\n"),
                      edge = file("edge.csv", "x,y\n0.01,0.5\n");
    const auto in_low = ring(0, 0.6), in_high = ring(0.4, 1), in_pond = ring(0.3, 0.45);
    const std::vector<PolygonRing> rock{{{0.7, 0.7}}}, line{{{0.1, 0.5}, {0.9, 0.6}}},
        around{{{0.01, 0.5}}, {{1.01, 0.5}}};
    const Mask* const border = drawn({{.rings = in_low, .distance = 0.01},
                                      {.rings = in_high, .distance = 0.01},
                                      {.rings = in_pond, .role = Role::outside, .distance = 0.01},
                                      {.rings = rock, .role = Role::outside, .distance = 0.1}});
    const Mask* const by_radius =
        drawn({{.rings = in_low, .distance = 0.015},
               {.rings = rock, .role = Role::outside, .distance = 0.115}});
    const Mask* const near = drawn({{.rings = line, .role = Role::near, .distance = 0.2},
                                    {.rings = rock, .role = Role::near, .distance = 0.1},
                                    {.rings = line, .role = Role::outside, .distance = 0.05}});
    const Mask* const torus = drawn({{.rings = around, .role = Role::outside, .distance = 0.2}});
    const Words common{"--edge", "0.003", "--domain", "1x1", "--radius", "0.03"};
    expect_arrivals(
        {{joined(common, {"--inside", low, "--inside", high, "--outside", pond, "--avoid", rocks,
                          "--border", "0.01"}),
          {.radius = 0.03, .places = {.mask = border, .border = 0.01}}},
         // Objects of half of the distance of two.
         {joined(common, {"--inside", low, "--avoid", rocks, "--inside-by-radius"}),
          {.radius = 0.03, .places = {.mask = by_radius, .border = 0.015}}},
         {joined(common, {"--near", road + ":0.2", "--near", rocks, "--avoid", road + ":0.05"}),
          {.radius = 0.03, .places = {.mask = near}}},
         {joined(common, {"--avoid", edge + ":0.2", "--torus"}),
          {.domain = {.boundary = Boundary::torus}, .radius = 0.03, .places = {.mask = torus}}}});
}

TEST_F(OptionsOfSample, ThatNameClassesArriveInTheRequest) {
    const std::string left = file("left.pgm", std::string("P5 2 1 255\n") + bytes({255, 0})),
                      top = file("top.pgm", std::string("P5 1 2 255\n") + bytes({255, 0})),
                      matrix = file("m.csv", "# a, b\n0.05, 0.08\n0.08, 0.02\n"),
                      same = file("m.json", "[[0.05, 0.08], [0.08, 0.02]]"),
                      keep = file("keep.csv", "x,y,class\n0.25,0.5,b\n0.75,0.5,a\n"),
                      low = square("low.txt", "0", "0.6"), high = square("high.txt", "0.4", "1"),
                      pond = square("pond.txt", "0.3", "0.45");
    const auto in_low = ring(0, 0.6), in_high = ring(0.4, 1), in_pond = ring(0.3, 0.45);
    const Mask left_half{2, 1, {1, 0}}, top_half{1, 2, {1, 0}};
    const std::vector<Point> kept{{0.25, 0.5}, {0.75, 0.5}};
    const std::vector<std::uint8_t> kinds{1, 0};
    const Classes two{.names = {"a", "b"}, .distances = distances_by_sum(std::vector{0.05, 0.02})};
    const auto with = [&](const auto& change) {
        Request request{.classes = two};
        change(request);
        return request;
    };
    const Words common{"--class", "a:0.05", "--class", "b:0.02", "--domain", "1x1"};
    const auto of_matrix = with([](Request& r) {
        r.classes.distances = {0.05, 0.08, 0.08, 0.02};
        r.classes.weights = {1, 3};
    });
    const auto each = [&](double a, double b) {
        return std::vector<const Mask*>{
            drawn({{.rings = in_low, .distance = a},
                   {.rings = in_pond, .role = Role::outside, .distance = a}}),
            drawn({{.rings = in_high, .distance = b}})};
    };
    const Words of_each{"--inside",  low,         "--inside", "b:" + high,
                        "--outside", "a:" + pond, "--edge",   "0.003"};
    expect_arrivals(
        {{joined(common, {"--mask", "a:" + left, "--mask", top}), with([&](Request& r) {
              r.places.mask = &top_half;
              r.places.masks = {&left_half, nullptr};
          })},
         {joined(common, {"--border", "a:0.2", "--border", "0.03"}), with([](Request& r) {
              r.places.border = 0.03;
              r.places.borders = {0.2, 0.03};
          })},
         {joined(common, {"--inside-by-radius"}), with([](Request& r) {
              r.places.borders = {0.05, 0.02};
          })},
         // Two of a class keep its radius, so that objects are half as large.
         {joined(common, {"--between", "union", "--inside-by-radius"}), with([](Request& r) {
              r.classes.distances = distances_by_union(std::vector{0.05, 0.02});
              r.places.borders = {0.025, 0.01};
          })},
         {joined(common, of_each), with([&](Request& r) { r.places.masks = each(0, 0); })},
         {joined(joined(common, of_each), {"--inside-by-radius"}), with([&](Request& r) {
              r.places.masks = each(0.05, 0.02);
              r.places.borders = {0.05, 0.02};
          })},
         {{"--class", "a:0.05:1:12", "--class", "b:0.02"}, with([](Request& r) {
              r.classes.counts = {12, {}};
          })},
         {joined(common, {"--priority"}), with([](Request& r) { r.classes.by_priority = true; })},
         {{"--class", "a", "--class", "b::3", "--between", matrix}, of_matrix},
         {{"--class", "a", "--class", "b::3", "--between", same}, of_matrix},
         {joined(common, {"--between", "union", "--keep", keep}), with([&](Request& r) {
              r.classes.distances = distances_by_union(std::vector{0.05, 0.02});
              r.keep = kept;
              r.keep_classes = kinds;
          })}});
}

TEST(OptionsOfStipple, ArriveInTheLibrary) {
    const Folder folder;
    const std::string picture = gradient(folder);
    const std::vector<std::pair<Words, StippleOptions>> cases{
        {{"--count", "300", "--seed", "9", "--relax", "2", "--black", "0.1", "--white", "0.8",
          "--min-importance", "0.05", "--sharpen", "2:3"},
         {.request = {.count = 300, .seed = 9},
          .relax = 2,
          .tone = {.black = 0.1,
                   .white = 0.8,
                   .min_importance = 0.05,
                   .sharpen = 2,
                   .sharpen_amount = 3}}},
        {{"--scale", "0.03", "--mode", "cells", "--metric", "max", "--relax", "0", "--torus",
          "--limit", "80", "--lines-per-radius", "5", "--round-size", "7", "--auto-levels"},
         {.request = {.domain = {.boundary = Boundary::torus},
                      .scale = 0.03,
                      .limit = 80,
                      .paper2011 = {.lines_per_radius = 5, .round_size = 7}},
          .start = Mode::cells,
          .metric = Metric::max,
          .relax = 0,
          .tone = {.auto_levels = true}}},
        {{"--count", "200", "--mode", "exact", "--along", "4", "--backend", "reference"},
         {.request = {.count = 200, .run_on = {.backend = "reference"}},
          .start = Mode::exact,
          .tone = {.along = 4}}},
        {{"--inks", "red,#0000ff", "--black-ink", "0.5", "--ink-counts", "70,50", "--relax", "1"},
         {.relax = 1, .inks = inks_of("red,#0000ff"), .black_ink = 0.5, .ink_counts = {70, 50}}},
        {{"--count", "200", "--size-by-tone", "0.7", "--keep-inside", "--pen-path"},
         {.request = {.count = 200}, .size_by_tone = 0.7, .keep_inside = true, .pen_path = true}},
        {{"--dot-size", "1mm..2mm", "--paper-size", "A5", "--margin", "2cm", "--keep-inside",
          "--relax", "1"},
         {.relax = 1,
          .pens = Pens{1, 2},
          .paper = Paper{148, 210, 20, true},
          .keep_inside = true}}};
    for (const auto& [words, options] : cases) {
        Words command{"stipple", picture};
        EXPECT_EQ(points_by(folder, command, words),
                  stipple(read_picture(picture), options).result.points)
            << words[0] << ' ' << words[1];
    }
}

}  // namespace arrives_test
