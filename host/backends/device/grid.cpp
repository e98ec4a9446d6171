// The sample grid of modes lines and exact on a device.
#include "backends/device/grid.h"

#include <vector>

#include "portable/bits.h"
#include "portable/status.h"

namespace lacuna::device {
namespace {

constexpr std::uint64_t kGridScreenWork = 3;  // of a draw, see Queue::launch

}  // namespace

Grid::Grid(RoundMemory& round) : round_(round) {
    for (Buffer* const coordinate : {&round_.memory.grid_x, &round_.memory.grid_y}) {
        round_.make_room(*coordinate, cells());
        round_.queue.fill(*coordinate, NO_SAMPLE, cells());
    }
    round_.make_room(round_.memory.cell_heads, cells());
    round_.make_room(round_.memory.new_cells, words());
    empty_lists();
}

std::uint64_t Grid::cells() const {
    return std::uint64_t{round_.geometry.grid_columns} * round_.geometry.grid_rows;
}

void Grid::empty_lists() {
    round_.queue.fill(round_.memory.cell_heads, NO_SAMPLE, cells());
    lists_candidates_ = false;
}

std::uint64_t Grid::words() const {
    return std::uint64_t{round_.geometry.grid_columns} *
           portable::words_of_column(round_.geometry.grid_rows);
}

void Grid::begin_new_cells() {
    round_.queue.fill(round_.memory.new_cells, 0, words());
}

void Grid::screen(Range draws, std::uint32_t status, bool opens) {
    // A round that ended before its samples were inserted has left lists.
    if (opens && lists_candidates_) empty_lists();
    lists_candidates_ = lists_candidates_ || opens;
    round_.make_room(round_.memory.next_candidates, round_.draw_count);
    round_.screen<kernels::screen>(draws, status, kGridScreenWork, opens);
}

void Grid::insert(bool marks) {
    portable::DrawArguments arguments = round_.arguments();
    arguments.is_listed = marks ? 1 : 0;
    round_.launch_over_draws<kernels::insert>(arguments, 1);
    lists_candidates_ = false;
}

void Grid::snapshot(Snapshot& snapshot) {
    std::vector<std::uint32_t> x(cells()), y(cells());
    round_.get<std::uint32_t>(round_.memory.grid_x, x);
    round_.get<std::uint32_t>(round_.memory.grid_y, y);
    round_.queue.wait();
    for (std::size_t i = 0; i < x.size(); ++i) snapshot.grid.push_back({x[i], y[i]});
}

void Grid::restore(const Snapshot& snapshot) {
    // In lines a snapshot has no grid: what samples cover is cut from the spans.
    std::vector<std::uint32_t> x(cells(), NO_SAMPLE), y(cells(), NO_SAMPLE);
    for (std::size_t i = 0; i < snapshot.grid.size(); ++i) {
        x[i] = snapshot.grid[i].x;
        y[i] = snapshot.grid[i].y;
    }
    empty_lists();
    round_.put<std::uint32_t>(round_.memory.grid_x, x);
    round_.put<std::uint32_t>(round_.memory.grid_y, y);
    round_.queue.wait();
}

}  // namespace lacuna::device
