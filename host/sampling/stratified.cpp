// Mode stratified: inverts the cdf of importance along a Hilbert curve.
#include "sampling/stratified.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "relax/lattice.h"
#include "rounds/random.h"
#include "sampling/curve.h"

namespace lacuna {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr std::uint32_t kStream = 0x57a7;  // a stream of random numbers that no other sampler uses

// The cells of the curve: pixels, or equal parts of them where pixels are far from square.
struct CurveCells {
    const Field& field;
    std::vector<std::uint16_t> masses;  // of pixels, from the lowest row up
    std::uint32_t cut_x = 1;            // cells of a pixel
    std::uint32_t cut_y = 1;

    CurveCells(const Request& request, const Field& the_field, const Poll& poll)
        : field(the_field), masses(relaxing::masses_of(field, poll)) {
        constexpr double kMostCells = 1 << 28;
        const double aspect =
            request.domain.width / field.columns / (request.domain.height / field.rows);
        const double most = kMostCells / static_cast<double>(masses.size());
        const auto cut = [&](double wanted) {
            return static_cast<std::uint32_t>(std::max(1.0, std::round(std::min(wanted, most))));
        };
        cut_x = cut(aspect);
        cut_y = cut(1 / aspect);
        const std::uint32_t more = further_cut(static_cast<double>(*request.count) /
                                               (static_cast<double>(columns()) * rows()));
        cut_x *= more;
        cut_y *= more;
    }
    std::uint32_t columns() const { return field.columns * cut_x; }
    std::uint32_t rows() const { return field.rows * cut_y; }
    std::size_t pixel_of(Cell cell) const {
        const auto column = static_cast<std::size_t>(cell.x) / cut_x;
        const auto row = static_cast<std::size_t>(cell.y) / cut_y;
        return row * field.columns + column;
    }
    // Cuts that many points a cell, on both axes. Where intervals of the cdf are squares, 4^k of
    // them a cell, relaxed points keep traces of a square lattice. So cells are cut to bring the
    // number near 2 * 4^k, where intervals are twice as long as wide.
    static std::uint32_t further_cut(double points_a_cell) {
        if (points_a_cell < 25) return 1;
        const auto distance = [&](std::uint32_t cut) {  // a factor from 1 to 2
            double left = points_a_cell / (cut * cut);
            while (left >= 4) left /= 4;
            return std::max(left / 2, 2 / left);
        };
        return std::min({1u, 3u, 5u}, [&](std::uint32_t a, std::uint32_t b) {
            return distance(a) < distance(b);
        });
    }
    std::uint64_t mass() const {
        std::uint64_t sum = 0;
        for (const std::uint16_t mass : masses) sum += mass;
        return sum * cut_x * cut_y;
    }
};

// Follows the cdf along the curve, cell by cell, and puts points where it reaches their ranks.
class Walk {
public:
    Walk(const Request& request, const CurveCells& cells, OnCurve* listener)
        : request_(request), cells_(cells), listener_(listener), mass_(cells.mass()) {
        points_.reserve(*request.count);
        find_rank();
    }

    // Which way the curve leaves a cell is known at its next one.
    void enter(Cell cell) {
        if (has_cell_) leave(cell.x - cell_.x, cell.y - cell_.y);
        cell_ = cell;
        has_cell_ = true;
    }
    std::vector<Point> finish() {
        leave(1, 0);
        return std::move(points_);
    }

private:
    static constexpr unsigned kShift = 32;  // ranks are in 2^-32 of the unit of mass

    void leave(std::int64_t dx, std::int64_t dy) {
        const Way way = way_to(at_right_, at_top_, dx, dy);
        const std::size_t pixel = cells_.pixel_of(cell_);
        const std::uint64_t mass = cells_.masses[pixel];
        const std::uint64_t end = before_ + mass;
        for (; rank_ >> kShift < end && points_.size() < *request_.count; find_rank()) {
            // Less than mass << kShift, which has 48 bits.
            const auto in_cell = static_cast<std::uint64_t>(rank_ - (Wide{before_} << kShift));
            const auto part = static_cast<std::uint32_t>(in_cell / mass);
            put(way.at(part));
            if (listener_ != nullptr) listener_->put(pixel, part * 0x1p-32);
        }
        before_ += mass;
        if (listener_ != nullptr) listener_->leave(pixel);
    }
    void put(InCell at) {
        const auto scaled = [](std::int64_t cell, std::uint32_t in_cell, std::uint32_t cells) {
            return (static_cast<double>(cell) + (in_cell + 0.5) * 0x1p-16) / cells;
        };
        const Domain& domain = request_.domain;
        // These positions are so fine that a sum with the corner may be rounded to the upper edge.
        const auto along = [](double corner, double side, double share) {
            const double end = corner + side;
            const double sum = corner + side * share;
            return sum < end ? sum : std::nextafter(end, corner);
        };
        points_.push_back({along(domain.x0, domain.width, scaled(cell_.x, at.x, cells_.columns())),
                           along(domain.y0, domain.height, scaled(cell_.y, at.y, cells_.rows()))});
    }
    // The rank of the next point: at random in the middle half of its interval of the cdf. In the
    // middle itself the points of a uniform domain would be a square lattice, and anywhere in the
    // interval they are less even after relaxing.
    void find_rank() {
        const std::uint64_t i = points_.size();
        const std::uint64_t random = random_bits(request_.seed, i, kStream).first >> (kShift + 1);
        constexpr std::uint64_t kQuarter = std::uint64_t{1} << (kShift - 2);
        rank_ = Wide{(i << kShift) + kQuarter + random} * mass_ / *request_.count;
    }

    const Request& request_;
    const CurveCells& cells_;
    OnCurve* listener_;
    std::uint64_t mass_;  // of all cells
    Cell cell_{0, 0};
    bool has_cell_ = false;
    bool at_right_ = false;  // the corner at which the curve enters the cell
    bool at_top_ = false;
    std::uint64_t before_ = 0;  // the mass of all earlier cells
    Wide rank_ = 0;
    std::vector<Point> points_;
};

}  // namespace

std::vector<Point> stratified_points(const Request& request, const Poll& poll, OnCurve* listener) {
    const CurveCells cells(request, relaxing::field_or_even(request.field), poll);
    if (listener != nullptr) listener->begin(std::uint64_t{cells.cut_x} * cells.cut_y);
    Walk walk(request, cells, listener);
    std::size_t visited = 0;
    for_each_on_curve(cells.columns(), cells.rows(), [&](Cell cell) {
        if (visited++ % kBetweenPolls == 0) poll();
        walk.enter(cell);
    });
    return walk.finish();
}

}  // namespace lacuna
