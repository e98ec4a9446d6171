// Mode pixels: exactly as many samples as asked for, each on a pixel of its own, in proportion to
// the field and evenly spread.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "fields.h"
#include "refusal.h"

namespace lacuna::tests {

// On a domain whose unit is a pixel.
Request on_pixels(Raster raster, std::uint64_t count, Boundary boundary = Boundary::box) {
    Request request;
    request.domain = {static_cast<double>(raster.columns), static_cast<double>(raster.rows),
                      boundary};
    request.mode = Mode::pixels;
    request.on_pixels = raster;
    request.count = count;
    return request;
}

// Which pixels have a sample, row by row from the lowest. Each point must be in a pixel's centre.
std::vector<int> samples_of(const Request& request) {
    const Raster& raster = *request.on_pixels;
    std::vector<int> samples(raster.pixels());
    for (const Point& point : sample(request).points) {
        const auto column =
            static_cast<std::uint32_t>(point.x / request.domain.width * raster.columns);
        const auto row = static_cast<std::uint32_t>(point.y / request.domain.height * raster.rows);
        EXPECT_EQ(point, raster.centre(column, row, request.domain));
        ++samples.at(std::size_t{row} * raster.columns + column);
    }
    return samples;
}

TEST(SamplesOnPixels, AreAsManyAsAskedForAndEachHasAPixelOfItsOwn) {
    for (const Boundary boundary : {Boundary::box, Boundary::torus})
        for (const Raster raster : {Raster{61, 40}, Raster{1, 1}, Raster{2, 2}, Raster{3, 1},
                                    Raster{1, 300}, Raster{7, 5}})
            for (std::uint64_t tenths = 1; tenths <= 10; ++tenths) {
                const std::uint64_t count = (raster.pixels() * tenths + 9) / 10;
                const std::vector<int> samples = samples_of(on_pixels(raster, count, boundary));
                ASSERT_EQ(std::count(samples.begin(), samples.end(), 1),
                          static_cast<std::ptrdiff_t>(count));
                ASSERT_LE(*std::max_element(samples.begin(), samples.end()), 1);
            }
}

// Dense in the middle, as masks for magnetic resonance imaging are.
Field middle_field(std::uint32_t columns, std::uint32_t rows) {
    return made_field(columns, rows, [](double x, double y) {
        return 1 / (0.003 + std::pow(x - 0.5, 2) + std::pow(y - 0.5, 2));
    });
}

// The share of each pixel, row by row from the lowest: at most one sample, all together `count`.
std::vector<double> shares_of(const Field& field, double count) {
    double low = 0, high = 1e9;
    std::vector<double> shares(field.importance.size());
    for (int i = 0; i < 200; ++i) {
        const double factor = (low + high) / 2;
        double sum = 0;
        for (std::size_t pixel = 0; pixel < shares.size(); ++pixel) {
            const std::size_t row = field.rows - 1 - pixel / field.columns;
            shares[pixel] = std::min(
                1.0, factor * field.importance[row * field.columns + pixel % field.columns]);
            sum += shares[pixel];
        }
        (sum < count ? low : high) = factor;
    }
    return shares;
}

TEST(SamplesOnPixels, FillTheMiddleOfAFieldAndGiveEachOtherPartItsShare) {
    const Field field = middle_field(192, 128);
    for (const std::uint64_t count : {2000u, 4000u, 16'000u}) {
        Request request = on_pixels({192, 128}, count);
        request.field = &field;
        const std::vector<int> samples = samples_of(request);
        const std::vector<double> shares = shares_of(field, static_cast<double>(count));
        constexpr std::size_t kBlock = 16;
        std::size_t full = 0;
        for (std::size_t y = 0; y < 128; y += kBlock)
            for (std::size_t x = 0; x < 192; x += kBlock) {
                double fair = 0, got = 0;
                for (std::size_t i = 0; i < kBlock * kBlock; ++i) {
                    const std::size_t pixel = (y + i / kBlock) * 192 + x + i % kBlock;
                    fair += shares[pixel];
                    got += samples[pixel];
                    if (shares[pixel] < 0.9999) continue;
                    ++full;
                    ASSERT_EQ(samples[pixel], 1) << count << ", pixel " << pixel;
                }
                EXPECT_NEAR(got, fair, 5) << count << " at " << x << ", " << y;
            }
        EXPECT_GT(full, 100u) << count;
        EXPECT_EQ(std::accumulate(samples.begin(), samples.end(), 0), static_cast<int>(count));
    }
}

// |sum of (sample - share) e^(-2 pi i k x)|^2 over the mean of this for white noise.
double power_at(const std::vector<int>& samples, std::uint32_t side, int i, int j) {
    const double share =
        std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
    std::complex<double> sum = 0;
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x)
            sum += (samples[std::size_t{y} * side + x] - share) *
                   std::polar(1.0, 2 * std::numbers::pi *
                                       (i * static_cast<double>(x) + j * static_cast<double>(y)) /
                                       side);
    return std::norm(sum) / (share * (1 - share) * static_cast<double>(samples.size()));
}

TEST(SamplesOnPixels, HaveAHundredthOfThePowerOfWhiteNoiseAtLowFrequencies) {
    constexpr std::uint32_t kSide = 128;
    for (const auto& [percent, most] :
         {std::pair(5u, 0.01), {10u, 0.01}, {25u, 0.03}, {50u, 0.03}, {75u, 0.03}, {90u, 0.01}}) {
        const std::vector<int> samples =
            samples_of(on_pixels({kSide, kSide}, kSide * kSide * percent / 100, Boundary::torus));
        // Up to a quarter of the frequency of the samples, or of the pixels without one.
        const double spacing = 1 / std::sqrt(std::min(percent, 100 - percent) / 100.0);
        const int reach = static_cast<int>(kSide / spacing / 4);
        double sum = 0;
        int frequencies = 0;
        for (int i = 0; i <= reach; i += 2)
            for (int j = -reach; j <= reach; j += 2) {
                if (i * i + j * j == 0 || i * i + j * j > reach * reach) continue;
                sum += power_at(samples, kSide, i, j);
                ++frequencies;
            }
        EXPECT_LT(sum / frequencies, most) << percent << " %";
    }
}

TEST(SamplesOnPixels, AreTheSameOnAnyDomain) {
    Request request = on_pixels({100, 60}, 900);
    const std::vector<Point> points = sample(request).points;
    request.domain = {50, 30, Boundary::box, -7, 1000};
    const std::vector<Point> moved = sample(request).points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        ASSERT_EQ(moved[i].x, points[i].x / 2 - 7);
        ASSERT_EQ(moved[i].y, points[i].y / 2 + 1000);
    }
}

TEST(SamplesOnPixels, ComeRowByRowFromTheTop) {
    const std::vector<Point> points = sample(on_pixels({40, 30}, 300)).points;
    EXPECT_TRUE(std::is_sorted(points.begin(), points.end(), [](Point a, Point b) {
        return std::pair(-a.y, a.x) < std::pair(-b.y, b.x);
    }));
}

TEST(SamplesOnPixels, LieWhereTheirCentresAreAllowed) {
    Request request = on_pixels({60, 60}, 400);
    const Mask mask{2, 1, {0, 1}};
    request.places.mask = &mask;
    for (const Point& point : sample(request).points) EXPECT_GT(point.x, 30);
    request.count = 1800;
    EXPECT_EQ(sample(request).points.size(), 1800u);
    request.count = 1801;
    EXPECT_EQ(refusal_of([&] { sample(request); }),
              "count 1801: must be at most 1800, the number of pixels where samples may lie");
}

TEST(SamplesOnPixels, HaveTheLeastDistanceOfTwoPixelsAsTheirRadius) {
    Request request = on_pixels({100, 80}, 2000, Boundary::torus);
    EXPECT_EQ(sample(request).radius, 1);
    request.domain = {1, 1, Boundary::torus, 300'000.1, -0.3};
    EXPECT_NEAR(sample(request).radius, 0.01, 1e-9);
    EXPECT_EQ(sample(on_pixels({1, 1}, 1)).radius, 0);
}

}  // namespace lacuna::tests
