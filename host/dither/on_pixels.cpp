// Mode pixels: each pixel has a share of the samples, at most one. Samples begin along a Hilbert
// curve, pixel by pixel (Deville & Tille 1998, "Unequal probability sampling without replacement
// through a splitting method"), and then move from pixel to pixel (pixel_descent.cpp). Whole
// numbers decide, so the samples are the same on every machine.
#include "dither/on_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "dither/pixel_descent.h"
#include "dither/pixel_shares.h"
#include "lattice/curve.h"
#include "lattice/lattice.h"
#include "plan/mask_tree.h"
#include "rounds/random.h"

namespace lacuna {
namespace {

// Streams of random numbers that nothing else uses.
constexpr std::uint32_t kPixelStream = 0x9e1, kPixelCurveStream = 0x9e2;

std::vector<std::uint64_t> masses_on(const Request& request, const Poll& poll) {
    const Raster& raster = *request.on_pixels;
    const Field& field = relaxing::field_or_even(request.field);
    // The most pixels of the raster that have the same pixel of the field.
    const double often = std::ceil(double{1} * raster.columns / field.columns) *
                         std::ceil(double{1} * raster.rows / field.rows);
    const std::vector<std::uint64_t> given =
        relaxing::masses_of(field, PixelShares::kMostMass / often, poll);
    const Mask* const mask = request.places.mask;
    std::vector<std::uint64_t> masses(raster.pixels());
    // The pixel of a picture, stretched over the raster, at the centre of the raster's pixel.
    const auto at = [](std::uint64_t i, std::uint64_t of, std::uint64_t pixels) {
        return static_cast<std::size_t>((2 * i + 1) * pixels / (2 * of));
    };
    const auto fill_row = [&](std::size_t y) {
        for (std::uint32_t x = 0; x < raster.columns; ++x) {
            bool may_lie = true;
            if (mask != nullptr && mask->drawn)
                may_lie = mask->drawn->holds(
                    raster.centre(x, static_cast<std::uint32_t>(y), request.domain));
            else if (mask != nullptr)
                may_lie = mask->allowed[(mask->rows - 1 - at(y, raster.rows, mask->rows)) *
                                            mask->columns +
                                        at(x, raster.columns, mask->columns)] != 0;
            if (may_lie)
                masses[y * raster.columns + x] =
                    given[at(y, raster.rows, field.rows) * field.columns +
                          at(x, raster.columns, field.columns)];
        }
    };
    for_each_polled(raster.rows, poll, fill_row, raster.columns);
    return masses;
}

// Which pixels have a sample at first. Along the curve the share of one pixel is carried on: where
// it meets the next one, chance gives both to one of them, or fills one up to a sample.
std::vector<std::uint8_t> first_samples(const Request& request, const PixelShares& shares,
                                        const Poll& poll) {
    const Raster& raster = *request.on_pixels;
    std::vector<std::uint8_t> taken(shares.masses.size());
    std::size_t carrier = 0, visited = 0;
    std::uint64_t carried = 0;  // a sample is shares.mass
    const auto meet = [&](std::size_t pixel) {
        const std::uint64_t own = shares.masses[pixel] * shares.count;
        const std::uint64_t both = carried + own;
        const std::uint64_t random = random_bits(request.seed, pixel, kPixelStream).first;
        if (both < shares.mass) {
            if (scaled(random, both) >= carried) carrier = pixel;
            carried = both;
            return;
        }
        const bool first_is_full = scaled(random, 2 * shares.mass - both) < shares.mass - own;
        taken[first_is_full ? carrier : pixel] = 1;
        if (first_is_full) carrier = pixel;
        carried = both - shares.mass;
    };
    const PixelGrid grid{raster.columns, raster.rows, 1, 1, request.domain.wraps()};
    RandomCurve(grid, request.seed, kPixelCurveStream).follow([&](const InPixel& part) {
        if (visited++ % kBetweenPolls == 0) poll();
        const std::size_t pixel = part.pixel;
        if (shares.is_full(pixel)) taken[pixel] = 1;
        if (!shares.is_open(pixel) || shares.count == 0) return;
        if (carried == 0) {
            carrier = pixel;
            carried = shares.masses[pixel] * shares.count;
        } else {
            meet(pixel);
        }
    });
    return taken;
}

}  // namespace

std::vector<Point> points_on_pixels(const Request& request, const Poll& poll) {
    const Raster& raster = *request.on_pixels;
    const PixelShares shares(masses_on(request, poll), *request.count);
    std::vector<std::uint8_t> taken = first_samples(request, shares, poll);
    descend_on_pixels(raster, request.domain.wraps(), shares, taken);
    std::vector<Point> points;
    points.reserve(*request.count);
    for (std::uint32_t y = raster.rows; y-- > 0;) {
        poll();
        for (std::uint32_t x = 0; x < raster.columns; ++x)
            if (taken[std::size_t{y} * raster.columns + x] != 0)
                points.push_back(raster.centre(x, y, request.domain));
    }
    return points;
}

}  // namespace lacuna
