// Mode stratified: inverts the cdf of importance along a Hilbert curve.
#include "lattice/stratified.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "lattice/curve.h"
#include "lattice/lattice.h"
#include "rounds/random.h"

namespace lacuna {
namespace {

__extension__ using Wide = unsigned __int128;

// Streams of random numbers that nothing else uses.
constexpr std::uint32_t kStream = 0x57a7, kCurveStream = 0x57a8;

// Into how many parts, on both axes, to cut cells that have this many points on average: at least
// so many that parts have at most an eighth of a point.
std::uint32_t least_cut(double points_a_cell) {
    constexpr double kCellsAPoint = 8;
    return static_cast<std::uint32_t>(
        std::max(1.0, std::ceil(std::sqrt(kCellsAPoint * points_a_cell))));
}

// The same where all cells have equally many points. Each square of the curve then has r 4^k
// points, r from 1 to 4. With an r near 3 relaxed points have a third more power at low frequencies
// than with others, so that cut is chosen, of those up to twice the least, which brings r nearest
// to 2.
std::uint32_t even_cut(double points_a_cell) {
    const auto distance = [&](std::uint32_t cut) {  // a factor from 1 to 2
        double points = points_a_cell / (double{1} * cut * cut);
        while (points < 1) points *= 4;
        while (points >= 4) points /= 4;
        return std::max(points / 2, 2 / points);
    };
    const std::uint32_t least = least_cut(points_a_cell);
    std::uint32_t best = least;
    for (std::uint32_t cut = least + 1; cut < 2 * least; ++cut)
        if (distance(cut) < distance(best)) best = cut;
    return best;
}

// Cells that the curve passes: pixels cut into parts, which are nearly square, so that the least
// cells are small against the mean interval.
PixelGrid grid_of(const Request& request, const Field& field) {
    constexpr double kMostCells = 1 << 26;
    const Domain& domain = request.domain;
    const double aspect = domain.width / field.columns / (domain.height / field.rows);
    const double most = kMostCells / static_cast<double>(field.importance.size());
    const auto cut = [&](double wanted) {
        return static_cast<std::uint32_t>(std::max(1.0, std::round(std::min(wanted, most))));
    };
    PixelGrid grid{field.columns, field.rows, cut(aspect), cut(1 / aspect), domain.wraps()};
    const double points_a_cell =
        static_cast<double>(*request.count) / static_cast<double>(grid.width() * grid.height());
    const std::uint32_t more =
        field.importance.size() == 1 ? even_cut(points_a_cell) : least_cut(points_a_cell);
    grid.cut_x *= more;
    grid.cut_y *= more;
    return grid;
}

// Follows the cdf along the curve, square by square, and puts points where it reaches their ranks.
class Walk {
public:
    Walk(const Request& request, const PixelGrid& grid, const RandomCurve& curve, const Poll& poll,
         OnCurve* listener)
        : request_(request),
          grid_(grid),
          listener_(listener),
          masses_(relaxing::masses_of(relaxing::field_or_even(request.field),
                                      kMostMass / (double{1} * grid.cut_x * grid.cut_y), poll)),
          phase_(curve.phase()) {
        const std::uint64_t cells = std::uint64_t{grid.cut_x} * grid.cut_y;
        for (const std::uint64_t mass : masses_) mass_ += mass * cells;
        points_.reserve(*request.count);
        if (in_interval(0) < kOne) interval_ = 1;
        find_rank();
    }

    void pass(const InPixel& part) {
        const std::uint64_t mass = masses_[part.pixel] * part.cells();
        const std::uint64_t end = before_ + mass;
        for (; rank_ >> kShift < end && points_.size() < *request_.count; find_rank()) {
            const Wide passed = rank_ - (Wide{before_} << kShift);  // less than mass << kShift
            const auto share = static_cast<std::uint32_t>(passed / mass);
            put(part, share);
            if (listener_ != nullptr)
                listener_->put(part.pixel, share * 0x1p-32 * static_cast<double>(part.cells()));
        }
        before_ = end;
        if (listener_ != nullptr) listener_->leave(part.pixel, static_cast<double>(part.cells()));
    }
    std::vector<Point> finish() { return std::move(points_); }

private:
    static constexpr unsigned kShift = 32;  // ranks are in 2^-32 of the unit of mass
    static constexpr std::uint64_t kOne = std::uint64_t{1} << kShift;
    static constexpr double kMostMass = 0x1p62;

    void put(const InPixel& part, std::uint32_t share) {
        const auto [x, y] = part.square.at(share);
        // These positions are so fine that a sum with the corner may be rounded to the upper edge.
        const auto along = [](double corner, double side, std::uint64_t lowest, double in_square,
                              std::uint64_t all) {
            const double cell = static_cast<double>(lowest) + in_square;
            const auto cells = static_cast<double>(all);
            const double end = corner + side;
            const double sum = corner + side * ((cell < cells ? cell : cell - cells) / cells);
            return sum < end ? sum : std::nextafter(end, corner);
        };
        const Domain& domain = request_.domain;
        points_.push_back({along(domain.x0, domain.width, part.x, x, grid_.width()),
                           along(domain.y0, domain.height, part.y, y, grid_.height())});
    }
    // Where a point lies after the beginning of its interval, in 2^-32 of an interval: the curve's
    // random phase, and a random number in the middle half. In the middle itself the points of a
    // uniform domain would be a square lattice, and anywhere in the interval they are less even
    // after relaxing.
    std::uint64_t in_interval(std::uint64_t interval) const {
        constexpr std::uint64_t kQuarter = kOne / 4;
        return phase_ + kQuarter +
               (random_bits(request_.seed, interval, kStream).first >> (kShift + 1));
    }
    // The rank of the next point. Intervals begin one interval before the curve does, because the
    // phase moves points on by up to one; the first and the last interval are the same one.
    void find_rank() {
        const std::uint64_t i = interval_++;
        rank_ =
            Wide{(i << kShift) + in_interval(i % *request_.count) - kOne} * mass_ / *request_.count;
    }

    const Request& request_;
    const PixelGrid& grid_;
    OnCurve* listener_;
    std::vector<std::uint64_t> masses_;  // of the cells of a pixel, from the lowest row up
    std::uint64_t phase_;
    std::uint64_t mass_ = 0;    // of all cells
    std::uint64_t before_ = 0;  // the mass of all earlier cells
    std::uint64_t interval_ = 0;
    Wide rank_ = 0;
    std::vector<Point> points_;
};

}  // namespace

std::vector<Point> stratified_points(const Request& request, const Poll& poll, OnCurve* listener) {
    const PixelGrid grid = grid_of(request, relaxing::field_or_even(request.field));
    const RandomCurve curve(grid, request.seed, kCurveStream);
    if (listener != nullptr) listener->begin(std::uint64_t{grid.cut_x} * grid.cut_y);
    Walk walk(request, grid, curve, poll, listener);
    std::size_t visited = 0;
    curve.follow([&](const InPixel& part) {
        if (visited++ % kBetweenPolls == 0) poll();
        walk.pass(part);
    });
    return walk.finish();
}

}  // namespace lacuna
