// The points are sorted into cells: by column, then by row within a column. On a torus, copies of
// the first columns follow the last one, and copies of the rows at either edge lie beyond the other
// edge. Each pair is counted from the point that comes first in this order, so half of the cells
// around a point suffice. In each column the points of the cells within reach are one run in
// memory.
#include "analysis/close_pairs.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>

namespace lacuna::analysis {
namespace {

// One axis of the domain, cut into cells.
struct Side {
    double length;
    std::size_t cells;
    std::size_t reach;  // in cells; a larger difference along this axis alone exceeds the distance

    Side(double side, double distance, double most_cells) : length(side) {
        constexpr double kCellsWithin = 4;  // with smaller cells runs are too short
        cells = static_cast<std::size_t>(
            std::clamp(std::floor(kCellsWithin * side / distance), 1.0, most_cells));
        // The factor is a little over 1, because coordinates are rounded when cells are computed.
        reach =
            1 + static_cast<std::size_t>(1.000001 * distance / side * static_cast<double>(cells));
    }
    std::size_t cell_of(double at) const {
        return std::min(static_cast<std::size_t>(at / length * static_cast<double>(cells)),
                        cells - 1);
    }
    double cell_length() const { return length / static_cast<double>(cells); }
};

class Cells {
public:
    Cells(std::span<const Point> points, const Domain& domain, double distance, const Poll& poll)
        : x_(domain.width, distance, most_cells(points.size(), domain.width, domain.height)),
          y_(domain.height, distance, most_cells(points.size(), domain.height, domain.width)),
          stride_(y_.cells + 2 * y_.reach),
          begins_((x_.cells + x_.reach + 1) * stride_ + 1) {
        const auto for_each = [&](const auto& visit) {
            for_each_polled(points.size(), poll,
                            [&](std::size_t i) { for_each_image(points[i], domain, visit); });
        };
        for_each([&](std::size_t cell, double, double) { ++begins_[cell + 1]; });
        for (std::size_t cell = 1; cell < begins_.size(); ++cell)
            begins_[cell] += begins_[cell - 1];
        xs_.resize(begins_.back());
        ys_.resize(begins_.back());
        std::vector<std::size_t> next = begins_;
        for_each([&](std::size_t cell, double x, double y) {
            const std::size_t place = next[cell]++;
            xs_[place] = x;
            ys_[place] = y;
        });
        find_reaches(distance);
    }

    struct Run {
        std::size_t begin;
        std::size_t end;
    };
    // The points, without the copies beyond the edges, in runs of at most kMost points.
    std::vector<Run> runs() const {
        constexpr std::size_t kMost = 256;
        std::vector<Run> runs;
        for (std::size_t column = 0; column < x_.cells; ++column) {
            const std::size_t first = column * stride_ + y_.reach;
            const std::size_t end = begins_[first + y_.cells];
            for (std::size_t begin = begins_[first]; begin < end; begin += kMost)
                runs.push_back({begin, std::min(begin + kMost, end)});
        }
        return runs;
    }

    // Calls visit(run) for runs that contain all points that come after the one at `place` and can
    // be within the distance.
    template <class Visit>
    void for_each_run(std::size_t place, const Visit& visit) const {
        const std::size_t column = x_.cell_of(xs_[place]);
        const std::size_t row = y_.cell_of(ys_[place]) + y_.reach;
        visit(Run{place + 1, begins_[column * stride_ + row + y_.reach + 1]});
        for (std::size_t i = 0; i < rows_within_.size(); ++i) {
            const std::size_t centre = (column + 1 + i) * stride_ + row;
            visit(Run{begins_[centre - rows_within_[i]], begins_[centre + rows_within_[i] + 1]});
        }
    }

    const double* xs() const { return xs_.data(); }
    const double* ys() const { return ys_.data(); }

private:
    // Limit for the cells along a side: about one cell for each point, also in a thin domain.
    static double most_cells(std::size_t points, double side, double other) {
        const auto count = static_cast<double>(points);
        return std::clamp(std::sqrt(count) * std::sqrt(side / other), 1.0, count);
    }

    template <class Visit>
    void for_each_image(Point point, const Domain& domain, const Visit& visit) const {
        const std::size_t column = x_.cell_of(point.x);
        const std::size_t row = y_.cell_of(point.y);
        const auto add = [&](std::size_t of_column, double x) {
            const std::size_t cell = of_column * stride_ + row + y_.reach;
            visit(cell, x, point.y);
            if (!domain.torus) return;
            if (row < y_.reach) visit(cell + y_.cells, x, point.y + domain.height);
            if (row + y_.reach >= y_.cells) visit(cell - y_.cells, x, point.y - domain.height);
        };
        add(column, point.x);
        if (domain.torus && column < x_.reach) add(column + x_.cells, point.x + domain.width);
    }

    // The farther a column is, the fewer of its rows are within the distance.
    void find_reaches(double distance) {
        for (std::size_t i = 0; i < x_.reach; ++i) {
            const double gap = static_cast<double>(i) * x_.cell_length();
            const double left = std::sqrt(std::max(0.0, distance * distance - gap * gap));
            rows_within_.push_back(std::min(
                y_.reach, 1 + static_cast<std::size_t>(1.000001 * left / y_.cell_length())));
        }
    }

    Side x_;
    Side y_;
    std::size_t stride_;               // cells of a column, copies beyond the edges included
    std::vector<std::size_t> begins_;  // index of the first point of each cell
    std::vector<double> xs_;
    std::vector<double> ys_;
    std::vector<std::size_t> rows_within_;  // above and below: for each next column
};

// Counts pairs by bins; the last bin is for pairs that are farther apart.
class Counter {
public:
    Counter(double width, std::size_t bins) : width_(width), counts_(bins + 1, 0) {}

    // Counts the pairs of a point with `count` others.
    void add(double x, double y, const double* xs, const double* ys, std::size_t count) {
        for (std::size_t i = 0; i < count; i += kBlock) {
            const auto size = static_cast<Eigen::Index>(std::min<std::size_t>(kBlock, count - i));
            const Eigen::Map<const Eigen::ArrayXd> other_x(xs + i, size);
            const Eigen::Map<const Eigen::ArrayXd> other_y(ys + i, size);
            found_.head(size) = (((other_x - x).square() + (other_y - y).square()).sqrt() / width_)
                                    .min(static_cast<double>(counts_.size() - 1));
            for (Eigen::Index j = 0; j < size; ++j)
                ++counts_[static_cast<std::size_t>(static_cast<std::int64_t>(found_[j]))];
        }
    }

    const std::vector<std::uint64_t>& counts() const { return counts_; }

private:
    static constexpr int kBlock = 64;
    double width_;
    std::vector<std::uint64_t> counts_;
    Eigen::Array<double, kBlock, 1> found_;
};

}  // namespace

std::vector<std::uint64_t> count_close_pairs(std::span<const Point> points, const Domain& domain,
                                             double width, std::size_t bins, const Poll& poll) {
    const Cells cells(points, domain, width * static_cast<double>(bins), poll);
    const std::vector<Cells::Run> runs = cells.runs();
    tbb::enumerable_thread_specific<Counter> counters(width, bins);
    const auto count = [&](std::size_t task) {
        Counter& counter = counters.local();
        for (std::size_t i = runs[task].begin; i < runs[task].end; ++i)
            cells.for_each_run(i, [&](const Cells::Run& run) {
                counter.add(cells.xs()[i], cells.ys()[i], cells.xs() + run.begin,
                            cells.ys() + run.begin, run.end - run.begin);
            });
    };
    constexpr std::size_t kRunsPerPoll = 32;
    for (std::size_t begin = 0; begin < runs.size(); begin += kRunsPerPoll) {
        poll();
        tbb::parallel_for(begin, std::min(begin + kRunsPerPoll, runs.size()), count);
    }
    std::vector<std::uint64_t> counts(bins, 0);
    for (const Counter& counter : counters)
        std::transform(counts.begin(), counts.end(), counter.counts().begin(), counts.begin(),
                       std::plus<>());
    return counts;
}

}  // namespace lacuna::analysis
