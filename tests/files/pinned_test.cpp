// The bytes of some small requests, pinned by hash: they may change with a major version only.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include "files/point_files.h"

namespace {

using namespace lacuna;

std::string hash_of(const Request& request) {
    return files::sha256_of(sample(request).points);
}

Request request_of(double radius, Boundary boundary, Mode mode = Mode::lines) {
    Request request;
    request.mode = mode;
    request.radius = radius;
    request.domain.boundary = boundary;
    request.place.backend = "reference";
    return request;
}

TEST(Pinned, Torus) {
    EXPECT_EQ(hash_of(request_of(0.05, Boundary::torus)),
              "3b0964181e873e82999a69989ea581a0cb741bca0ddfb279887b9bf622468c76");
}

TEST(Pinned, RectangularBoxOnTheLines) {
    Request request = request_of(0.07, Boundary::box);
    request.domain.width = 2.5;
    request.paper2011.snap = true;
    request.seed = 1;
    EXPECT_EQ(hash_of(request), "7eb075153dc967a65b533f1ab589e0da22c968d77360c9ca7e44b60d2015d5ca");
}

TEST(Pinned, UniformX) {
    Request request = request_of(0.05, Boundary::torus);
    request.paper2011.uniform_x = true;
    request.paper2011.lines_per_radius = 10;
    EXPECT_EQ(hash_of(request), "6390ed06fa443cc3784c761579692a450fc0adb248e252f678cd9a2e6d917149");
}

TEST(Pinned, OneDrawARound) {
    Request request = request_of(0.05, Boundary::box);
    request.paper2011.round_size = 1;
    request.seed = 18446744073709551615u;
    EXPECT_EQ(hash_of(request), "e295d3c6a8c47c012624a83f3fa1c678e339d76ed1d3768aed31736932f4ab98");
}

TEST(Pinned, ExactTorus) {
    EXPECT_EQ(hash_of(request_of(0.05, Boundary::torus, Mode::exact)),
              "5e6e955e4e8eeb9ffeb93a289334f16ddaf21d9ac8fb82123b7cc888645affc7");
}

TEST(Pinned, ExactRectangularBox) {
    Request request = request_of(0.07, Boundary::box, Mode::exact);
    request.domain.width = 2.5;
    request.seed = 1;
    EXPECT_EQ(hash_of(request), "94881e5f8418912158604aec6dba0a099e3e8fa0e58ec6c42b7b2864e7046086");
}

TEST(Pinned, ExactInSmallRounds) {
    Request request = request_of(0.05, Boundary::torus, Mode::exact);
    request.paper2011.round_size = 1;
    request.paper2011.lines_per_radius = 1;
    EXPECT_EQ(hash_of(request), "535d0fd8551c4b744c33c19bb1f1d6eb46b335a7bf082fb0482ecf4c9e6596d3");
}

TEST(Pinned, Count) {
    Request request;
    request.mode = Mode::lines;
    request.count = 1000;
    request.place.backend = "reference";
    EXPECT_EQ(hash_of(request), "ff23fa2a80379ce0e4659fbd8a059b2ce7acafdb4094cf28244c992909f8069f");
}

}  // namespace
