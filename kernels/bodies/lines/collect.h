// The body of collect: lists the samples of the round that may cut the lines of a column in one
// tile, row by row of the sample grid, from the bottom up. All lines of the column use the list.
#include "portable/bits.h"
#include "portable/column.h"

// The bits of new_cells[] in one word of each column of cells, joined.
BODY u32 joined_bits(MEMORY const Geometry g, const Stretch columns, const u32 word) {
    u32 bits = 0u;
    for (u32 k = 0u; k < columns.count; ++k) {
        const u32 column = nth_of_stretch(columns, k, g.grid_columns);
        bits = bits | AT(new_cells, column * words_of_column(g.grid_rows) + word);
    }
    return bits;
}

// Lists the new samples in the rows of `rows`, which are bits of a word. Returns the number listed.
BODY u32 list_rows(MEMORY const SlabArguments a, const Stretch columns, const u32 word,
                   const u32 rows, const u32 near_begin, const u32 listed) {
    u32 count = listed;
    for (u32 rest = rows; rest != 0u; rest = rest & (rest - 1u)) {
        const u32 bit = lowest_bit(rest);
        for (u32 k = 0u; k < columns.count; ++k) {
            const u32 column = nth_of_stretch(columns, k, a.g.grid_columns);
            const u32 bits = AT(new_cells, column * words_of_column(a.g.grid_rows) + word);
            if ((bits >> bit & 1u) == 0u) continue;
            const u32 cell = column * a.g.grid_rows + word * 32u + bit;
            if (count < a.near_room) {
                const Spot spot = {AT(grid_x, cell), AT(grid_y, cell)};
                STORE(near, near_begin + count, spot);
            }
            ++count;
        }
    }
    return count;
}

// Serves one tile of one column. If its list needs more room, it sets report[OVERFLOW_WORD]. Does
// nothing while admission is unfinished.
BODY void serve_collect(MEMORY const SlabArguments a, const u32 item) {
    const Geometry g = a.g;
    if (item >= g.columns * a.tiles || AT(report, a.last_pass) != 0u) return;
    const u32 first = first_line_of_column(item / a.tiles, g.lines, g.columns);
    const u32 end_line = first_line_of_column(item / a.tiles + 1u, g.lines, g.columns);
    const u32 begin = item % a.tiles * a.tile_height;
    const u32 end = begin + min(a.tile_height, g.height - begin);
    const Stretch columns = cells_near(first * g.strip_width, end_line * g.strip_width, g.radius,
                                       g.width, g.period_x, g.grid_side, g.grid_columns);
    const Stretch rows =
        cells_near(begin, end, g.radius, g.height, g.period_y, g.grid_side, g.grid_rows);
    u32 count = 0u;
    for (u32 i = 0u; i < rows.count;) {
        // The rows of one word.
        const u32 row = nth_of_stretch(rows, i, g.grid_rows);
        const u32 word = row / 32u;
        const u32 rows_end = min(min((word + 1u) * 32u, g.grid_rows), row + (rows.count - i));
        const u32 bits = joined_bits(ON g, columns, word) & word_mask(word, row, rows_end);
        count = list_rows(ON a, columns, word, bits, item * a.near_room, count);
        i += rows_end - row;
    }
    if (count > a.near_room) ATOMIC_SET(report, OVERFLOW_WORD, 1u);
    AT(near_counts, item) = min(count, a.near_room);
    CHECK_TURNS(g.height, FAILED_COLLECT);
}
