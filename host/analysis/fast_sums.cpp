// Sums at all frequencies at once: a non-uniform fast Fourier transform of type 1.
//
// Every point is spread onto the nearby nodes of a grid, the grid's discrete Fourier transform is
// computed, and each frequency is divided by the factor that the spreading caused (Dutt & Rokhlin
// 1993). Along each axis the grid has at least twice as many nodes as frequencies. The kernel is
// the "exponential of semicircle" of Barnett, Magland & af Klinteberg, A Parallel Nonuniform Fast
// Fourier Transform Library (SIAM Journal on Scientific Computing 41, 2019); it is kReach nodes
// wide, so the aliasing error is about 1e-13 of the largest sum. The transform is Eigen's, which is
// based on kissfft.
//
// The grid is never in memory as a whole. A band of its rows is filled and transformed along x, and
// only the wanted frequencies of it are kept; at last columns are transformed along y.
#include "analysis/fast_sums.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "base/polling.h"

namespace lacuna::analysis {
namespace {

using Complex = std::complex<double>;
using Transform = Eigen::FFT<double>;

constexpr int kReach = 14;  // number of nodes along an axis onto which a point is spread
constexpr double kSteepness = 2.3 * kReach;
constexpr std::size_t kBandRows = 32;     // rows of the grid in a task; must exceed kReach
constexpr std::size_t kChunkNodes = 256;  // along x: near points are spread together
constexpr std::size_t kColumns = 4;       // in a task: a cache line of a row

// The kernel exp(s (sqrt(1 - x^2) - 1)) at the nodes from `first` on, where x is the distance from
// `at` divided by half the reach.
using Weights = Eigen::Array<double, kReach, 1>;
Weights weights_around(double at, double first) {
    static const Weights steps = Weights::LinSpaced(0, kReach - 1);
    const Weights x = (steps + (first - at)) / (kReach / 2.0);
    return (kSteepness * ((1 - x.square()).max(0).sqrt() - 1)).exp();
}

double first_node(double at) {
    return std::ceil(at - kReach / 2.0);
}

// 1 / (the kernel's Fourier transform)^2 at the frequencies 0 to `most` of a grid with `nodes`
// nodes. With x = cos(angle) the integrand falls to exp(-s) at both ends, so that equal steps of
// the angle make the integral exact up to rounding.
std::vector<double> corrections(int most, std::size_t nodes) {
    constexpr int kSteps = 256;
    std::vector<double> at;
    std::vector<double> weights;
    for (int i = 1; i < kSteps; ++i) {
        const double angle = std::numbers::pi * i / kSteps;
        const double sine = std::sin(angle);
        at.push_back(std::cos(angle));
        weights.push_back(std::exp(kSteepness * (sine - 1)) * sine * std::numbers::pi / kSteps);
    }
    std::vector<double> corrections;
    for (int k = 0; k <= most; ++k) {
        const double turn = std::numbers::pi * kReach * k / static_cast<double>(nodes);
        double sum = 0;
        for (std::size_t i = 0; i < at.size(); ++i) sum += weights[i] * std::cos(turn * at[i]);
        corrections.push_back(1 / (sum * sum * (kReach / 2.0) * (kReach / 2.0)));
    }
    return corrections;
}

// Number of nodes: at least twice the number of frequencies from -most to most, a multiple of the
// band, and a product of 2, 3 and 5, for which the transform is fast.
std::size_t nodes_for(int most) {
    const std::size_t least = (4 * static_cast<std::size_t>(most) + 2 + kBandRows - 1) / kBandRows;
    for (std::size_t bands = least;; ++bands) {
        std::size_t rest = bands;
        for (const std::size_t factor : {2U, 3U, 5U})
            while (rest % factor == 0) rest /= factor;
        if (rest == 1) return bands * kBandRows;
    }
}

// The points in units of nodes, sorted by band and chunk of the first node they are spread onto.
class Sorted {
public:
    struct Place {
        double x;
        double y;
    };

    Sorted(std::span<const Point> points, const Domain& domain, std::size_t columns,
           std::size_t rows, const Poll& poll)
        : columns_(columns),
          rows_(rows),
          chunks_((columns + kChunkNodes - 1) / kChunkNodes),
          begins_(rows / kBandRows * chunks_ + 1),
          places_(points.size()) {
        const auto place = [&](const Point& point) {
            return Place{point.x / domain.width * static_cast<double>(columns),
                         point.y / domain.height * static_cast<double>(rows)};
        };
        for_each_polled(points.size(), poll,
                        [&](std::size_t i) { ++begins_[key_of(place(points[i])) + 1]; });
        for (std::size_t key = 1; key < begins_.size(); ++key) begins_[key] += begins_[key - 1];
        std::vector<std::size_t> next = begins_;
        for_each_polled(points.size(), poll, [&](std::size_t i) {
            const Place at = place(points[i]);
            places_[next[key_of(at)]++] = at;
        });
    }

    std::span<const Place> of_band(std::size_t band) const {
        const std::size_t begin = begins_[band * chunks_];
        return std::span(places_).subspan(begin, begins_[(band + 1) * chunks_] - begin);
    }

    // The first node onto which a point is spread. Nodes wrap, because frequencies are periodic.
    std::size_t column_of(double x) const { return wrapped(first_node(x), columns_); }
    std::size_t row_of(double y) const { return wrapped(first_node(y), rows_); }

private:
    static std::size_t wrapped(double node, std::size_t nodes) {
        return static_cast<std::size_t>(node < 0 ? node + static_cast<double>(nodes) : node);
    }
    std::size_t key_of(const Place& at) const {
        return row_of(at.y) / kBandRows * chunks_ + column_of(at.x) / kChunkNodes;
    }

    std::size_t columns_;
    std::size_t rows_;
    std::size_t chunks_;
    std::vector<std::size_t> begins_;
    std::vector<Place> places_;
};

// A band of the grid's rows. Two real rows are stored as one row of complex numbers, so that one
// transform serves both.
class Band {
public:
    explicit Band(std::size_t columns)
        : columns_(columns), stride_(columns + kReach), pairs_(kBandRows / 2 * stride_) {
        transform_.SetFlag(Transform::Unscaled);
        transformed_.resize(columns);
    }

    // Adds the points of this band, and the parts of the previous band's points that reach into it.
    void fill(const Sorted& sorted, std::size_t band, std::size_t bands) {
        std::fill(pairs_.begin(), pairs_.end(), Complex{});
        for (const Sorted::Place& at : sorted.of_band(band)) {
            const std::size_t row = sorted.row_of(at.y) % kBandRows;
            spread(sorted, at, row, 0, std::min<std::size_t>(kReach, kBandRows - row));
        }
        for (const Sorted::Place& at : sorted.of_band((band + bands - 1) % bands)) {
            const std::size_t own = kBandRows - sorted.row_of(at.y) % kBandRows;
            if (own < kReach) spread(sorted, at, 0, own, kReach);
        }
    }

    // Writes the frequencies 0 to most - 1 along x of each row to `into`, row by row.
    void transform(std::size_t most, Complex* into) {
        for (std::size_t pair = 0; pair < kBandRows / 2; ++pair) {
            Complex* row = &pairs_[pair * stride_];
            for (std::size_t i = 0; i < kReach; ++i) row[i] += row[columns_ + i];
            transform_.fwd(transformed_.data(), row, static_cast<Eigen::Index>(columns_));
            Complex* even = into + 2 * pair * most;
            Complex* odd = even + most;
            for (std::size_t k = 0; k < most; ++k) {
                const Complex above = transformed_[k];
                const Complex below = std::conj(transformed_[(columns_ - k) % columns_]);
                const Complex twice_odd = above - below;  // times i
                even[k] = (above + below) * 0.5;
                odd[k] = Complex{twice_odd.imag(), -twice_odd.real()} * 0.5;
            }
        }
    }

private:
    // Spreads a point's nodes [begin, end) along y onto the rows from `row` on.
    void spread(const Sorted& sorted, const Sorted::Place& at, std::size_t row, std::size_t begin,
                std::size_t end) {
        const Weights along_x = weights_around(at.x, first_node(at.x));
        const Weights along_y = weights_around(at.y, first_node(at.y));
        std::array<double, kReach + 2> rows{};  // whole pairs of rows, beginning with row & ~1
        for (std::size_t i = begin; i < end; ++i)
            rows[row % 2 + i - begin] = along_y[static_cast<Eigen::Index>(i)];
        const std::size_t pairs = (row % 2 + end - begin + 1) / 2;
        Complex* node = &pairs_[row / 2 * stride_ + sorted.column_of(at.x)];
        for (std::size_t pair = 0; pair < pairs; ++pair, node += stride_)
            for (int i = 0; i < kReach; ++i)
                node[i] += Complex{rows[2 * pair] * along_x[i], rows[2 * pair + 1] * along_x[i]};
    }

    std::size_t columns_;
    std::size_t stride_;  // the nodes after the last column are added to the first ones later
    std::vector<Complex> pairs_;
    std::vector<Complex> transformed_;
    Transform transform_;
};

// Calls work(task) for all tasks in parallel. Calls `keep_going` after each batch, with progress
// from `from` to `to`.
template <class Work>
void in_parallel(std::size_t tasks, const KeepGoing& keep_going, double from, double to,
                 const Work& work) {
    const auto batch = 2 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    for (std::size_t begin = 0; begin < tasks; begin += batch) {
        const std::size_t end = std::min(begin + batch, tasks);
        tbb::parallel_for(begin, end, work, tbb::simple_partitioner());
        if (!keep_going(from + (to - from) * static_cast<double>(end) / static_cast<double>(tasks)))
            throw Cancelled();
    }
}

// The fraction of the time that the rows take, for the progress.
constexpr double kShareOfRows = 0.7;

// A few columns of the half-transformed grid.
class Columns {
public:
    explicit Columns(std::size_t rows) : rows_(rows), columns_(kColumns * rows), column_(rows) {
        transform_.SetFlag(Transform::Unscaled);
    }

    // Copies `count` columns from `first` on, from a grid of `width` columns.
    void gather(const Complex* grid, std::size_t width, std::size_t first, std::size_t count) {
        for (std::size_t row = 0; row < rows_; ++row)
            for (std::size_t i = 0; i < count; ++i)
                columns_[i * rows_ + row] = grid[row * width + first + i];
    }

    // The frequencies of column i; negative ones at the end.
    std::span<const Complex> transform(std::size_t i) {
        transform_.fwd(column_.data(), &columns_[i * rows_], static_cast<Eigen::Index>(rows_));
        return column_;
    }

private:
    std::size_t rows_;
    std::vector<Complex> columns_;
    std::vector<Complex> column_;
    Transform transform_;
};

}  // namespace

std::vector<double> fast_periodogram(std::span<const Point> points, const Domain& domain,
                                     Range range, const KeepGoing& keep_going) {
    const std::size_t columns = nodes_for(range.kx_max);
    const std::size_t rows = nodes_for(range.ky_max);
    const std::size_t width = static_cast<std::size_t>(range.kx_max) + 1;
    const auto grid = std::make_unique_for_overwrite<Complex[]>(rows * width);
    {
        const Sorted sorted(points, domain, columns, rows, [&] {
            if (!keep_going(0)) throw Cancelled();
        });
        const std::size_t bands = rows / kBandRows;
        tbb::enumerable_thread_specific<Band> band(columns);
        in_parallel(bands, keep_going, 0, kShareOfRows, [&](std::size_t i) {
            band.local().fill(sorted, i, bands);
            band.local().transform(width, &grid[i * kBandRows * width]);
        });
    }
    const std::vector<double> x_corrections = corrections(range.kx_max, columns);
    const std::vector<double> y_corrections = corrections(range.ky_max, rows);
    const std::size_t height = 2 * static_cast<std::size_t>(range.ky_max) + 1;
    const auto count = static_cast<double>(points.size());
    std::vector<double> powers(width * height);
    tbb::enumerable_thread_specific<Columns> some(rows);
    const auto tasks = (width + kColumns - 1) / kColumns;
    in_parallel(tasks, keep_going, kShareOfRows, 1, [&](std::size_t task) {
        const std::size_t first = task * kColumns;
        const std::size_t here = std::min(kColumns, width - first);
        some.local().gather(grid.get(), width, first, here);
        for (std::size_t i = 0; i < here; ++i) {
            const std::span<const Complex> sums = some.local().transform(i);
            double* power = &powers[(first + i) * height];
            for (int ky = -range.ky_max; ky <= range.ky_max; ++ky)
                *power++ = std::norm(sums[ky < 0 ? rows - static_cast<std::size_t>(-ky)
                                                 : static_cast<std::size_t>(ky)]) *
                           x_corrections[first + i] *
                           y_corrections[static_cast<std::size_t>(std::abs(ky))] / count;
        }
    });
    powers[static_cast<std::size_t>(range.ky_max)] = 0;  // DC
    return powers;
}

}  // namespace lacuna::analysis
