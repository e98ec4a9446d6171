// The sample grid of mode exact on a device.
#include "backends/device/grid.h"

#include <vector>

#include "portable/status.h"

namespace lacuna::device {
namespace {

constexpr std::uint64_t kGridScreenWork = 3;  // of a draw, see Queue::launch

}  // namespace

Grid::Grid(RoundMemory& round) : round_(round) {
    const std::uint64_t cells = std::uint64_t{round_.plan.grid().columns} * round_.plan.grid().rows;
    for (Buffer* const coordinate : {&round_.memory.grid_x, &round_.memory.grid_y}) {
        round_.make_room(*coordinate, cells);
        round_.queue.fill(*coordinate, NO_SAMPLE, cells);
    }
}

void Grid::screen(Range draws, std::uint32_t status) {
    round_.screen<kernels::screen>(draws, status, kGridScreenWork);
}

void Grid::insert() {
    round_.launch_over_draws<kernels::insert>(round_.arguments(), 1);
}

void Grid::snapshot(Snapshot& snapshot) {
    const std::size_t cells = std::size_t{round_.plan.grid().columns} * round_.plan.grid().rows;
    std::vector<std::uint32_t> x(cells), y(cells);
    round_.get<std::uint32_t>(round_.memory.grid_x, x);
    round_.get<std::uint32_t>(round_.memory.grid_y, y);
    round_.queue.wait();
    for (std::size_t i = 0; i < cells; ++i) snapshot.grid.push_back({x[i], y[i]});
}

void Grid::restore(const Snapshot& snapshot) {
    std::vector<std::uint32_t> x, y;
    for (const Sample sample : snapshot.grid) {
        x.push_back(sample.x);
        y.push_back(sample.y);
    }
    round_.put<std::uint32_t>(round_.memory.grid_x, x);
    round_.put<std::uint32_t>(round_.memory.grid_y, y);
    round_.queue.wait();
}

}  // namespace lacuna::device
