// Pictures to stipple, and what tests ask of their dots.
#pragma once

#include <lacuna/stipple.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lacuna::tests::stippled {

// Red at the left, blue at the right, grey above, and white between.
inline const Picture kDrawing{
    "P3 4 3 255 90 90 90 90 90 90 90 90 90 90 90 90 "
    "230 20 20 255 255 255 255 255 255 20 40 230 "
    "230 20 20 255 255 255 255 255 255 20 40 230",
    "drawing"};
inline const Picture kBlack{"P2 1 1 1 0", "black"};

inline StippleOptions counted(std::uint64_t count) {
    StippleOptions options;
    options.request.count = count;
    return options;
}

inline StippleOptions in_inks(const std::string& inks, std::uint64_t count) {
    StippleOptions options = counted(count);
    options.inks = inks_of(inks);
    return options;
}

inline double mean_of(const Field& field) {
    return std::accumulate(field.importance.begin(), field.importance.end(), 0.0) /
           static_cast<double>(field.importance.size());
}

inline std::vector<std::size_t> dots_of(const Stippling& made) {
    std::vector<std::size_t> dots;
    for (const Layer& layer : made.layers) dots.push_back(layer.dots);
    return dots;
}

inline std::vector<std::pair<double, double>> sorted(std::span<const Point> points) {
    std::vector<std::pair<double, double>> all;
    for (const Point& point : points) all.emplace_back(point.x, point.y);
    std::sort(all.begin(), all.end());
    return all;
}

// 64 x 64 pixels, from black at the left to white at the right, or in another order of greys.
inline Picture ramp(int step = 1) {
    std::string pixels = "P2 64 64 63";
    for (int i = 0; i < 64 * 64; ++i) pixels += ' ' + std::to_string(i * step % 64);
    return {pixels, "ramp"};
}

}  // namespace lacuna::tests::stippled
