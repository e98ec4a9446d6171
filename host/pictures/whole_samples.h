// Luminance of samples of 8 or 16 bits, in whole numbers until one last division.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "base/polling.h"
#include "pictures/image.h"

namespace lacuna::pictures {

// The sum is at most 10000 * 65535, which fits into 32 bits.
inline std::int32_t weighted(const Weights& weights, std::int32_t red, std::int32_t green,
                             std::int32_t blue) {
    return weights.red * red + weights.green * green + weights.blue * blue;
}

// Composites `weighted`, out of kAll * max, over the backdrop, at opacity alpha / max.
inline double over(Backdrop backdrop, std::int64_t weighted, std::int64_t alpha, std::int64_t max) {
    const std::int64_t behind = backdrop == Backdrop::white ? kAll * max : 0;
    return static_cast<double>(weighted * alpha + behind * (max - alpha)) /
           static_cast<double>(kAll * max * max);
}

// Fills a row of luminance. `at(column, channel)` returns a sample, 0 to max. 1 channel is grey, 2
// are grey and alpha, 3 are red, green and blue, 4 also alpha.
template <unsigned kChannels, class At>
void fill_row(std::span<double> row, std::int32_t max, const Reading& reading, const At& at) {
    ask_after(row.size());
    const Weights weights = reading.weights;
    const Backdrop backdrop = reading.backdrop;
    const double whole = max;
    for (std::size_t x = 0; x < row.size(); ++x) {
        if constexpr (kChannels == 1) {
            row[x] = at(x, 0) / whole;
        } else if constexpr (kChannels == 2) {
            row[x] = over(backdrop, kAll * at(x, 0), at(x, 1), max);
        } else {
            const std::int32_t colour = weighted(weights, at(x, 0), at(x, 1), at(x, 2));
            if constexpr (kChannels == 3)
                row[x] = colour / (kAll * whole);
            else
                row[x] = over(backdrop, colour, at(x, 3), max);
        }
    }
}

// Calls `use` with the number of channels as a constant, so that the compiler makes a separate loop
// over pixels for each number.
template <class Use>
void with_channels(unsigned channels, const Use& use) {
    switch (channels) {
        case 1:
            return use(std::integral_constant<unsigned, 1>{});
        case 2:
            return use(std::integral_constant<unsigned, 2>{});
        case 3:
            return use(std::integral_constant<unsigned, 3>{});
        default:
            return use(std::integral_constant<unsigned, 4>{});
    }
}

// Fills a row from samples that lie side by side, as in most formats: each is one byte or, if
// is_wide, two bytes with the higher one first.
inline void fill_row_from(const unsigned char* bytes, unsigned channels, bool is_wide,
                          std::span<double> row, std::int32_t max, const Reading& reading = {}) {
    with_channels(channels, [&](auto constant) {
        constexpr unsigned kChannels = constant;
        if (is_wide)
            fill_row<kChannels>(row, max, reading, [bytes](std::size_t x, std::size_t channel) {
                const unsigned char* pair = bytes + 2 * (x * kChannels + channel);
                return std::int32_t{pair[0]} * 256 + pair[1];
            });
        else
            fill_row<kChannels>(row, max, reading, [bytes](std::size_t x, std::size_t channel) {
                return std::int32_t{bytes[x * kChannels + channel]};
            });
    });
}

}  // namespace lacuna::pictures
