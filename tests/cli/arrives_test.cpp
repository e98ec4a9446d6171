// The options of sample and stipple arrive in the library: the command makes the set that the
// library makes of the same request.
#include <gtest/gtest.h>
#include <lacuna/domains.h>
#include <lacuna/stipple.h>

#include <string>
#include <utility>
#include <vector>

#include "cli/expectations.h"
#include "cli/pictures.h"
#include "files/read_points.h"
#include "program.h"

namespace arrives_test {

using namespace lacuna;
using namespace lacuna::tests;

std::vector<Point> points_by(const Folder& folder, Words command, const Words& options) {
    command.insert(command.end(), options.begin(), options.end());
    command.insert(command.end(), {"--quiet", "-o", folder.path("made.csv")});
    expect_success(command);
    return files::read_points(folder.path("made.csv"));
}

// Lighter to the right, 24 x 16 pixels.
std::string gradient(const Folder& folder) {
    std::string pixels;
    for (int row = 0; row < 16; ++row)
        for (int column = 0; column < 24; ++column)
            pixels += static_cast<char>(column * 11 + row / 4);
    return grey_picture(folder, 24, 16, pixels);
}

TEST(OptionsOfSample, ThatNamePicturesAndPointsArriveInTheRequest) {
    const Folder folder;
    const std::string mask = grey_picture(folder, 2, 1, bytes({0, 255}));
    const std::string keep = folder.path("keep.csv");
    write_file(keep, "x,y\n0.75,0.30000000000000004\n");
    const Mask allowed{2, 1, {0, 1}};
    const std::vector<Point> kept{{0.75, 0.30000000000000004}};
    EXPECT_EQ(points_by(folder, {"sample"},
                        {"--mask", mask, "--border", "0.02", "--keep", keep, "--radius", "0.05"}),
              sample({.domain = {.height = 0.5},
                      .radius = 0.05,
                      .mask = &allowed,
                      .border = 0.02,
                      .keep = kept})
                  .points);
    const Folder other;
    const std::string picture = gradient(other);
    const Field field = importance_of(read_picture(picture), {.invert = true, .gamma = 1.7});
    Request request{
        .domain = {.height = 2.0 / 3, .boundary = Boundary::torus}, .count = 300, .seed = 5};
    request.field = &field;
    EXPECT_EQ(points_by(folder, {"sample"},
                        {"--field", picture, "--count", "300", "--invert", "--gamma", "1.7",
                         "--torus", "--seed", "5"}),
              sample(request).points);
}

TEST(OptionsOfSample, ThatNamePlacesArriveInTheRequest) {
    const Folder folder;
    const auto square = [&](const char* name, const std::string& low, const std::string& high) {
        write_file(folder.path(name), low + " " + low + "\n" + high + " " + low + "\n" + high +
                                          " " + high + "\n" + low + " " + high + "\n");
        return folder.path(name);
    };
    const std::string low = square("low.txt", "0", "0.6"), high = square("high.txt", "0.4", "1"),
                      pond = square("pond.txt", "0.3", "0.45");
    write_file(folder.path("rocks.csv"), "radius,x,y\n0.1,0.7,0.7\n");
    const auto ring = [](double from, double to) {
        return std::vector<PolygonRing>{{{from, from}, {to, from}, {to, to}, {from, to}}};
    };
    const std::vector<std::vector<PolygonRing>> rings{
        ring(0, 0.6), ring(0.4, 1), ring(0.3, 0.45), {{{0.7, 0.7}}}};
    const std::vector<PolygonSet> sets{{.rings = rings[0], .distance = 0.01},
                                       {.rings = rings[1], .distance = 0.01},
                                       {.rings = rings[2], .forbidden = true, .distance = 0.01},
                                       {.rings = rings[3], .forbidden = true, .distance = 0.1}};
    const Mask mask = draw_places(sets, {1, 1}, 0.003);
    EXPECT_EQ(points_by(folder, {"sample"},
                        {"--inside", low, "--inside", high, "--outside", pond, "--avoid",
                         folder.path("rocks.csv"), "--border", "0.01", "--edge", "0.003",
                         "--radius", "0.03"}),
              sample({.radius = 0.03, .mask = &mask, .border = 0.01}).points);
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
         {.request = {.count = 200, .place = {.backend = "reference"}},
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
