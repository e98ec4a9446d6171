// Void and cluster: which pixel is the next one of an even pattern.
#include <lacuna/inks.h>
#include <lacuna/lacuna.h>
#include <lacuna/threshold_mask.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "base/power.h"
#include "rounds/random.h"

namespace lacuna {
namespace {

constexpr std::uint32_t kLeastSide = 8, kMostSide = 1024;
constexpr std::uint64_t kMostThresholds = std::uint64_t{kMostSide} * kMostSide;  // of all frames
// A stream of random numbers that nothing else uses: the first is for the place of the tile, others
// are for further frames.
constexpr std::uint32_t kFrameStream = 0xf4a3;
constexpr std::size_t kMinority = 10;  // a pattern begins with one pixel in kMinority
// The Gaussian's deviation in pixels, where one pixel in kMinority is set or fewer, and where more
// are. With 1.5 everywhere, as Ulichney has it, low frequencies have twice the power.
constexpr double kOfFew = 1.5, kOfMany = 2.6;
constexpr double kInTime = 1.9;  // of the Gaussian in time, in frames, as Wolfe et al. 2022 have it

// Pixels row by row, and frame by frame.
struct Tile {
    std::uint32_t columns;
    std::uint32_t rows;
    std::uint32_t frames;
    std::size_t pixels() const { return std::size_t{columns} * rows * frames; }
};

// How much the pixels of a pattern on a torus crowd each pixel, those of its frame and those of the
// other frames that lie on its place, and which of some pixels is crowded
// most or least. Crowding is counted in whole numbers, so that it is the same on every machine.
class Crowding {
public:
    // `deviation` of the Gaussian, in pixels.
    Crowding(const Tile& tile, double deviation)
        : columns_(tile.columns),
          rows_(tile.rows),
          frames_(tile.frames),
          crowd_(tile.pixels()),
          row_best_(std::size_t{rows_} * frames_, kUnknown) {
        const double falls = std::ceil(kReach * deviation);
        reach_x_ = std::min(static_cast<std::uint32_t>(falls), (columns_ - 1) / 2);
        reach_y_ = std::min(static_cast<std::uint32_t>(falls), (rows_ - 1) / 2);
        // exp(-1 / (2 deviation^2)) by a product, because std::exp differs between machines.
        constexpr double kEulerInverse = 0.36787944117144233;
        const double unit = power(kEulerInverse, 1 / (2 * deviation * deviation));
        for (std::uint32_t y = 0; y <= reach_y_; ++y)
            for (std::uint32_t x = 0; x <= reach_x_; ++x)
                kernel_.push_back(static_cast<std::int64_t>(
                    kScale * power(unit, static_cast<double>(x * x + y * y))));
        const double in_time = power(kEulerInverse, 1 / (2 * kInTime * kInTime));
        for (std::uint32_t t = 0; t <= frames_ / 2; ++t)
            in_time_.push_back(
                static_cast<std::int64_t>(kScale * power(in_time, static_cast<double>(t * t))));
    }

    // Adds the pixel's crowding, or takes it away.
    void add(std::size_t pixel, bool is_added) {
        const auto column = static_cast<std::uint32_t>(pixel % columns_);
        const auto row = static_cast<std::uint32_t>(pixel / columns_ % rows_);
        const std::size_t frame = pixel / columns_ / rows_;
        ask_after((2 * reach_x_ + 1) * std::size_t{2 * reach_y_ + 1} / 4 + rows_ / 8);
        for (std::uint32_t j = 0; j <= 2 * reach_y_; ++j) {
            const std::size_t y = frame * rows_ + (row + rows_ + j - reach_y_) % rows_;
            const std::int64_t* const kernel =
                &kernel_[std::size_t{away(j, reach_y_)} * (reach_x_ + 1)];
            std::int64_t* const line = &crowd_[y * columns_];
            for (std::uint32_t i = 0; i <= 2 * reach_x_; ++i) {
                std::int64_t& one = line[(column + columns_ + i - reach_x_) % columns_];
                one += is_added ? kernel[away(i, reach_x_)] : -kernel[away(i, reach_x_)];
            }
            row_best_[y] = kUnknown;
        }
        for (std::size_t t = 1; t < frames_; ++t) {
            const std::size_t y = (frame + t) % frames_ * rows_ + row;
            const std::int64_t crowd = in_time_[std::min(t, frames_ - t)];
            crowd_[y * columns_ + column] += is_added ? crowd : -crowd;
            row_best_[y] = kUnknown;
        }
    }

    void add(const std::vector<bool>& pattern) {
        for (std::size_t i = 0; i < pattern.size(); ++i)
            if (pattern[i]) add(i, true);
    }

    // The pixel among those where `is_one` is `wanted` that is crowded most or, if `sign` is -1,
    // least. Of equal ones it is the first. Only rows near pixels that were added are searched
    // anew.
    std::size_t most(const std::vector<bool>& is_one, bool wanted, std::int64_t sign) {
        std::size_t best = kNone;
        for (std::size_t y = 0; y < row_best_.size(); ++y) {
            if (row_best_[y] == kUnknown) row_best_[y] = most_of_row(y, is_one, wanted, sign);
            const std::size_t here = row_best_[y];
            if (here == kNone) continue;
            if (best == kNone || sign * crowd_[here] > sign * crowd_[best]) best = here;
        }
        return best;
    }

private:
    static constexpr double kReach = 7;  // in deviations, where the Gaussian is 2e-11
    static constexpr double kScale = 0x1p40;
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    static constexpr std::size_t kUnknown = kNone - 1;

    static std::uint32_t away(std::uint32_t at, std::uint32_t middle) {
        return at < middle ? middle - at : at - middle;
    }

    std::size_t most_of_row(std::size_t y, const std::vector<bool>& is_one, bool wanted,
                            std::int64_t sign) const {
        std::size_t best = kNone;
        for (std::size_t i = y * columns_; i < (y + 1) * columns_; ++i)
            if (is_one[i] == wanted && (best == kNone || sign * crowd_[i] > sign * crowd_[best]))
                best = i;
        return best;
    }

    std::uint32_t columns_;
    std::uint32_t rows_;
    std::uint32_t frames_;
    std::uint32_t reach_x_ = 0;
    std::uint32_t reach_y_ = 0;
    std::vector<std::int64_t> in_time_;  // by the number of frames between two
    std::vector<std::int64_t> kernel_;   // of the quadrant, row by row
    std::vector<std::int64_t> crowd_;
    std::vector<std::size_t> row_best_;  // of each row: the pixel, kNone or kUnknown
};

class Ranker {
public:
    explicit Ranker(const Tile& tile) : tile_(tile), ranks_(tile.pixels()) {}

    // The pixels of `first` have the least ranks, and those of `last` the greatest.
    std::vector<std::uint32_t> rank(std::vector<bool> first, std::vector<bool> last) {
        settle(first, last);
        settle(last, first);
        const std::size_t pixels = ranks_.size();
        thin(first, [](std::size_t left) { return left; });
        thin(last, [&](std::size_t left) { return pixels - 1 - left; });
        fill(first, last);
        return std::move(ranks_);
    }

private:
    // Moves the most crowded pixel of a pattern to the least crowded place, again and again, until
    // it is the same. Pixels of `other` are no such places.
    void settle(std::vector<bool>& pattern, const std::vector<bool>& other) {
        Crowding crowding(tile_, kOfMany), room(tile_, kOfMany);
        crowding.add(pattern);
        room.add(pattern);
        std::vector<bool> is_closed = other;
        for (std::size_t i = 0; i < pattern.size(); ++i)
            if (pattern[i]) is_closed[i] = true;
        for (std::size_t moves = 2 * count_of(pattern); moves > 0; --moves) {
            const std::size_t from = crowding.most(pattern, true, 1);
            pattern[from] = is_closed[from] = false;
            crowding.add(from, false);
            room.add(from, false);
            const std::size_t to = room.most(is_closed, false, -1);
            pattern[to] = is_closed[to] = true;
            crowding.add(to, true);
            room.add(to, true);
            if (to == from) return;
        }
    }

    // Ranks the pixels of a pattern: the most crowded of them is taken out, again and again. Each
    // time that half of them are gone, the Gaussian is wider.
    template <class RankOf>
    void thin(std::vector<bool> pattern, const RankOf& rank_of) {
        std::size_t left = count_of(pattern);
        while (left > 0) {
            const double share = static_cast<double>(left) / static_cast<double>(pattern.size());
            Crowding crowding(tile_, kOfFew / std::sqrt(share * kMinority));
            crowding.add(pattern);
            for (const std::size_t end = left / 2; left > end; --left) {
                const std::size_t pixel = crowding.most(pattern, true, 1);
                pattern[pixel] = false;
                crowding.add(pixel, false);
                ranks_[pixel] = static_cast<std::uint32_t>(rank_of(left - 1));
            }
        }
    }

    // Ranks the other pixels: the least crowded of them is added, again and again.
    void fill(const std::vector<bool>& first, const std::vector<bool>& last) {
        Crowding crowding(tile_, kOfMany);
        crowding.add(first);
        std::vector<bool> is_closed = first;
        for (std::size_t i = 0; i < last.size(); ++i)
            if (last[i]) is_closed[i] = true;
        const std::size_t end = ranks_.size() - count_of(last);
        for (std::size_t rank = count_of(first); rank < end; ++rank) {
            const std::size_t pixel = crowding.most(is_closed, false, -1);
            is_closed[pixel] = true;
            crowding.add(pixel, true);
            ranks_[pixel] = static_cast<std::uint32_t>(rank);
        }
    }

    static std::size_t count_of(const std::vector<bool>& pattern) {
        return static_cast<std::size_t>(std::count(pattern.begin(), pattern.end(), true));
    }

    Tile tile_;
    std::vector<std::uint32_t> ranks_;
};

// Two patterns without a common pixel: each is even, and so are both together, like the dots of two
// inks.
using Patterns = std::array<std::vector<bool>, 2>;
Patterns even_patterns(std::uint32_t columns, std::uint32_t rows, std::uint64_t seed) {
    constexpr std::uint32_t kIterations = 30;
    RelaxOptions options;
    options.domain = {static_cast<double>(columns), static_cast<double>(rows), Boundary::torus};
    options.iterations = kIterations;
    options.run_on.backend = "cpu";
    const Field everywhere{1, 1, {1}, {}};
    const std::uint64_t dots = std::uint64_t{columns} * rows / kMinority;
    const std::array<InkPart, 2> parts{{{&everywhere, dots}, {&everywhere, dots}}};
    const std::vector<Point> points = place_inks(parts, seed, options).points;
    Patterns patterns;
    for (std::vector<bool>& pattern : patterns) pattern.resize(std::size_t{columns} * rows);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto x = std::min(static_cast<std::uint32_t>(points[i].x), columns - 1);
        const auto y = std::min(static_cast<std::uint32_t>(points[i].y), rows - 1);
        const std::size_t pixel = std::size_t{rows - 1 - y} * columns + x;
        patterns[i < dots ? 0 : 1][pixel] = i < dots || !patterns[0][pixel];
    }
    return patterns;
}

// Moves all frames by the same random way, so that no pixel has better chances of low ranks than
// another. Across its edges a tile is the same everywhere.
std::vector<std::uint32_t> moved_at_random(const std::vector<std::uint32_t>& ranks,
                                           const Tile& tile, std::uint64_t seed) {
    const RandomBits random = random_bits(seed, 0, kFrameStream);
    const std::uint64_t right = scaled(random.first, tile.columns);
    const std::uint64_t down = scaled(random.second, tile.rows);
    std::vector<std::uint32_t> moved(ranks.size());
    for (std::size_t row = 0; row < std::size_t{tile.rows} * tile.frames; ++row) {
        const std::size_t in_frame = row % tile.rows;
        const auto from = ranks.begin() + static_cast<std::ptrdiff_t>(row * tile.columns);
        const std::size_t to = row - in_frame + (in_frame + down) % tile.rows;
        std::rotate_copy(from, from + static_cast<std::ptrdiff_t>(tile.columns - right),
                         from + static_cast<std::ptrdiff_t>(tile.columns),
                         moved.begin() + static_cast<std::ptrdiff_t>(to * tile.columns));
    }
    return moved;
}

}  // namespace

ThresholdMask threshold_mask(std::uint32_t columns, std::uint32_t rows, std::uint64_t seed,
                             std::uint32_t frames) {
    if (columns < kLeastSide || columns > kMostSide || rows < kLeastSide || rows > kMostSide)
        throw BadRequest("size", std::to_string(columns) + "x" + std::to_string(rows),
                         "each side must be 8 to 1024 pixels");
    if (frames == 0 || std::uint64_t{columns} * rows * frames > kMostThresholds)
        throw BadRequest("frames", std::to_string(frames),
                         "must be 1 to " + std::to_string(kMostThresholds / columns / rows) +
                             " for this size: all together have at most 1024x1024 pixels");
    Patterns all;
    for (std::uint32_t frame = 0; frame < frames; ++frame) {
        const std::uint64_t own = frame == 0 ? seed : random_bits(seed, frame, kFrameStream).first;
        const Patterns patterns = even_patterns(columns, rows, own);
        for (std::size_t i = 0; i < 2; ++i)
            all[i].insert(all[i].end(), patterns[i].begin(), patterns[i].end());
    }
    const Tile tile{columns, rows, frames};
    return {columns, rows, frames, moved_at_random(Ranker(tile).rank(all[0], all[1]), tile, seed)};
}

}  // namespace lacuna
