// Dart throwing on a grid whose cells are at least as wide as the radius.
#include "baseline/dart_throwing.h"

#include <algorithm>
#include <array>

#include "portable/distance.h"
#include "rounds/random.h"

namespace lacuna::baseline {
namespace {

// A stream of its own, so that darts and samples of one seed are independent.
constexpr std::uint32_t kStream = 0xda27;

// Samples by cell. Conflicts are at most one cell away, as cells are as wide as the radius or
// wider.
class Cells {
public:
    explicit Cells(const Plan& plan)
        : plan_(plan),
          columns_(std::max(1u, plan.width / plan.radius)),
          rows_(std::max(1u, plan.height / plan.radius)),
          cells_(std::size_t{columns_} * rows_) {}

    bool has_room_for(Sample dart) const {
        for (const std::uint32_t column : around(cell(dart.x, plan_.width, columns_), columns_))
            for (const std::uint32_t row : around(cell(dart.y, plan_.height, rows_), rows_))
                for (const Sample& sample : cells_[std::size_t{column} * rows_ + row])
                    if (portable::are_closer(sample.x, sample.y, dart.x, dart.y, plan_.period_x,
                                             plan_.period_y, plan_.radius_squared))
                        return false;
        return true;
    }

    void insert(Sample dart) {
        const std::size_t column = cell(dart.x, plan_.width, columns_);
        cells_[column * rows_ + cell(dart.y, plan_.height, rows_)].push_back(dart);
    }

private:
    static std::uint32_t cell(std::uint32_t at, std::uint32_t side, std::uint32_t count) {
        return static_cast<std::uint32_t>(std::uint64_t{at} * count / side);
    }
    // The cell and its two neighbours, wrapped. On a box the wrapped cells contain no conflicts.
    static std::array<std::uint32_t, 3> around(std::uint32_t cell, std::uint32_t count) {
        return {(cell + count - 1) % count, cell, (cell + 1) % count};
    }

    const Plan& plan_;
    std::uint32_t columns_;
    std::uint32_t rows_;
    std::vector<std::vector<Sample>> cells_;
};

}  // namespace

Darts throw_darts(const Plan& plan, std::uint64_t misses_in_a_row) {
    Darts darts;
    Cells cells(plan);
    std::uint64_t misses = 0;
    while (misses < misses_in_a_row && darts.samples.size() < plan.limit) {
        const RandomBits random = random_bits(plan.seed, darts.thrown++, kStream);
        const Sample dart{static_cast<std::uint32_t>(scaled(random.first, plan.width)),
                          static_cast<std::uint32_t>(scaled(random.second, plan.height))};
        if (cells.has_room_for(dart)) {
            cells.insert(dart);
            darts.samples.push_back(dart);
            misses = 0;
        } else {
            ++misses;
        }
    }
    return darts;
}

}  // namespace lacuna::baseline
