// The descent of the Gaussian energy on threads. In each step samples are sorted into a grid of
// cells, whose rows are contiguous. Each pair is computed once, and its force added to both: a
// sample looks at those after it in its own row of cells, and at the rows above.
#include "relax/cpu/gaussian.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <numeric>
#include <utility>

#include "base/workers.h"

namespace lacuna::relaxing::cpu {
namespace {

constexpr std::size_t kSamplesOfTask = 1024;
// Few blocks have long waits at their ends, many have short rows.
constexpr std::uint32_t kBlocksOfThread = 16;

// Samples in some order, which changes as they move.
struct Samples {
    std::vector<Spot> spots;
    std::vector<std::int32_t> momentum_x, momentum_y;
    std::vector<std::uint32_t> index;

    explicit Samples(std::size_t count)
        : spots(count), momentum_x(count), momentum_y(count), index(count) {}
};

// A row of cells at or above another one, and how far its image is shifted.
struct Row {
    std::size_t first_cell;
    std::uint32_t column_reach;
    std::uint32_t shift;
};

class CpuGaussian : public GaussianBackend {
public:
    CpuGaussian(const GaussianField& field, std::span<const Spot> spots, const Placement& placement,
                const Puller& puller)
        : field_(field),
          domain_(field.domain),
          workers_(placement.threads),
          puller_(puller),
          moved_(spots.size()),
          sorted_(spots.size()),
          cells_(spots.size()),
          ranks_(spots.size()),
          begins_(std::size_t{domain_.columns} * domain_.rows + 1) {
        std::iota(moved_.index.begin(), moved_.index.end(), 0u);
        std::copy(spots.begin(), spots.end(), moved_.spots.begin());
        for (auto* const values : {&pulled_.x, &pulled_.y, &pulled_.force_x, &pulled_.force_y})
            values->resize(spots.size());
    }

    std::string device() const override { return workers_.name(); }
    void watch(std::function<bool()> may_go_on) override { workers_.watch(std::move(may_go_on)); }

    void descend(std::uint32_t pace) override {
        sort();
        add_forces();
        for_chunks([&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) move(i, pace);
        });
    }

    std::vector<Spot> spots() override {
        std::vector<Spot> spots(moved_.spots.size());
        for (std::size_t i = 0; i < spots.size(); ++i) spots[moved_.index[i]] = moved_.spots[i];
        return spots;
    }

private:
    // Samples of one cell come in any order: sums of whole numbers do not depend on it.
    void sort() {
        std::fill(begins_.begin(), begins_.end(), 0);
        for_chunks([&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const auto [x, y] = moved_.spots[i];
                cells_[i] =
                    portable::gaussian_cell(y, domain_.rows, domain_.height) * domain_.columns +
                    portable::gaussian_cell(x, domain_.columns, domain_.width);
                ranks_[i] = std::atomic_ref<std::uint32_t>(begins_[cells_[i]])
                                .fetch_add(1, std::memory_order_relaxed);
            }
        });
        std::exclusive_scan(begins_.begin(), begins_.end(), begins_.begin(), 0u);
        for_chunks([&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const std::size_t to = begins_[cells_[i]] + ranks_[i];
                sorted_.spots[to] = moved_.spots[i];
                sorted_.momentum_x[to] = moved_.momentum_x[i];
                sorted_.momentum_y[to] = moved_.momentum_y[i];
                sorted_.index[to] = moved_.index[i];
                pulled_.x[to] = moved_.spots[i].x;
                pulled_.y[to] = moved_.spots[i].y;
                pulled_.force_x[to] = pulled_.force_y[to] = 0;
            }
        });
    }

    // Adds the forces of all pairs. A block of rows adds to the next block, too: so every second
    // block is served at once, and then the others. If their number is odd, the last comes alone.
    void add_forces() {
        const std::uint32_t rows_of_block =
            std::max({1u, domain_.row_reach, domain_.rows / (kBlocksOfThread * workers_.count())});
        const std::uint32_t blocks = std::max(1u, domain_.rows / rows_of_block);
        const auto serve = [&](std::uint32_t block) {
            const std::uint32_t end =
                block + 1 == blocks ? domain_.rows : (block + 1) * rows_of_block;
            for (std::uint32_t row = block * rows_of_block; row < end; ++row)
                add_forces_of_row(row);
        };
        const auto serve_every_second = [&](std::uint32_t first, std::uint32_t count) {
            workers_.for_columns(count, moved_.spots.size(),
                                 [&](std::uint32_t i) { serve(2 * i + first); });
        };
        serve_every_second(0, blocks / 2);
        serve_every_second(1, blocks / 2);
        if (blocks % 2 != 0) serve_every_second(blocks - 1, 1);
    }

    void add_forces_of_row(std::uint32_t row) {
        std::vector<Row> rows;
        for_images(row, std::int64_t{row} + domain_.row_reach, domain_.rows, domain_.height,
                   [&](std::uint32_t first, std::uint32_t last, std::uint32_t shift) {
                       for (std::uint32_t near = first; near <= last; ++near)
                           rows.push_back({std::size_t{near} * domain_.columns,
                                           field_.column_reaches[rows.size()], shift});
                   });
        std::vector<Run> runs;
        for (std::uint32_t column = 0; column < domain_.columns; ++column) {
            const std::size_t cell = std::size_t{row} * domain_.columns + column;
            for (std::size_t i = begins_[cell]; i < begins_[cell + 1]; ++i) {
                find_runs(i, column, rows, runs);
                const Force force =
                    puller_.pull(runs, field_.weights.data(), domain_.bits, pulled_);
                pulled_.force_x[i] += force.x;
                pulled_.force_y[i] += force.y;
            }
        }
    }

    // The samples after sample i in the first of the rows, and those near it in the others.
    void find_runs(std::size_t i, std::uint32_t column, std::span<const Row> rows,
                   std::vector<Run>& runs) const {
        const Spot at = sorted_.spots[i];
        const std::uint32_t farthest = rows.front().column_reach;
        const bool is_inner = column >= farthest && column + farthest < domain_.columns;
        runs.clear();
        for (const Row& row : rows) {
            const bool is_own = &row == &rows.front();
            const std::int64_t reach = row.column_reach;
            if (is_inner) {  // most are
                const std::size_t begin =
                    is_own ? i + 1 : begins_[row.first_cell + column - row.column_reach];
                const std::size_t end = begins_[row.first_cell + column + row.column_reach + 1];
                runs.push_back({begin, end - begin, at.x, at.y - row.shift});
                continue;
            }
            for_images(is_own ? column : column - reach, column + reach, domain_.columns,
                       domain_.width,
                       [&](std::uint32_t first, std::uint32_t last, std::uint32_t shift) {
                           std::size_t begin = begins_[row.first_cell + first];
                           if (is_own && shift == 0) begin = i + 1;
                           const std::size_t end = begins_[row.first_cell + last + 1];
                           if (begin < end)
                               runs.push_back({begin, end - begin, at.x - shift, at.y - row.shift});
                       });
        }
    }

    // Calls work(first, last, shift) for the cells of an axis from `from` to `to`, image by image:
    // cells below 0 and beyond the side are those of an image or, on a box, do not exist.
    template <typename Work>
    void for_images(std::int64_t from, std::int64_t to, std::uint32_t cells, std::uint32_t length,
                    Work work) const {
        const std::int64_t side = cells;
        const auto work_on = [&](std::int64_t image) {
            work(static_cast<std::uint32_t>(std::max<std::int64_t>(from - image * side, 0)),
                 static_cast<std::uint32_t>(std::min(to - image * side, side - 1)),
                 static_cast<std::uint32_t>(image) * length);
        };
        if (domain_.wraps == 0 || (from >= 0 && to < side)) return work_on(0);
        const auto image_of = [&](std::int64_t cell) {
            return cell >= 0 ? cell / side : -((side - 1 - cell) / side);
        };
        for (std::int64_t image = image_of(from); image <= image_of(to); ++image) work_on(image);
    }

    // Moves a sample of the sorted order, into the memory of the former order.
    void move(std::size_t i, std::uint32_t pace) {
        const Spot at = sorted_.spots[i];
        const Force edges = force_of_edges(field_, at);
        const auto along = [&](std::uint32_t from, std::int32_t before, std::int64_t force,
                               std::uint32_t length, std::uint32_t& to, std::int32_t& after) {
            after = portable::gaussian_momentum(before, force, domain_.bits);
            to = portable::gaussian_place(from, after, pace, length, domain_.wraps, domain_.bits);
        };
        along(at.x, sorted_.momentum_x[i], pulled_.force_x[i] + edges.x, domain_.width,
              moved_.spots[i].x, moved_.momentum_x[i]);
        along(at.y, sorted_.momentum_y[i], pulled_.force_y[i] + edges.y, domain_.height,
              moved_.spots[i].y, moved_.momentum_y[i]);
        moved_.index[i] = sorted_.index[i];
    }

    // Calls work(begin, end) for samples beside each other, in parallel.
    template <typename Work>
    void for_chunks(Work work) {
        const std::size_t samples = moved_.spots.size();
        const std::size_t chunks = (samples + kSamplesOfTask - 1) / kSamplesOfTask;
        workers_.for_columns(static_cast<std::uint32_t>(chunks), samples, [&](std::uint32_t chunk) {
            const std::size_t begin = chunk * kSamplesOfTask;
            work(begin, std::min(begin + kSamplesOfTask, samples));
        });
    }

    const GaussianField& field_;
    const portable::GaussianDomain& domain_;
    Workers workers_;
    const Puller& puller_;
    Samples moved_;                      // as the last step left them
    Samples sorted_;                     // by cell
    Pulled pulled_;                      // of sorted_
    std::vector<std::uint32_t> cells_;   // of the samples of moved_
    std::vector<std::uint32_t> ranks_;   // in their cells
    std::vector<std::uint32_t> begins_;  // of each cell's samples in sorted_, and their end
};

}  // namespace

std::unique_ptr<GaussianBackend> make_gaussian_backend(const GaussianField& field,
                                                       std::span<const Spot> spots,
                                                       const Placement& placement,
                                                       const Puller& puller) {
    return std::make_unique<CpuGaussian>(field, spots, placement, puller);
}

std::unique_ptr<GaussianBackend> make_gaussian_backend(const GaussianField& field,
                                                       std::span<const Spot> spots,
                                                       const Placement& placement, const Poll&) {
    return make_gaussian_backend(field, spots, placement, *all_pullers().front());
}

}  // namespace lacuna::relaxing::cpu
