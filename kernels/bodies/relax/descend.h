// The body of descend: sums the forces on a sample, and moves it.
#include "bodies/relax/cell_begin.h"
#include "portable/gaussian.h"

struct Pull {
    i64 x;
    i64 y;
};
LACUNA_TYPEDEF(Pull)

// Adds the forces of the samples [begin, end) on one at (x, y), modulo 2^32.
BODY Pull pull_of_run(MEMORY const DescentArguments a, const Pull before, const u32 begin,
                      const u32 end, const u32 x, const u32 y) {
    Pull pull = before;
    for (u32 k = begin; k < end; ++k) {
        const Mover other = LOAD(Mover, sorted_movers, k);
        const i64 dx = sign_extended(x - other.x);
        const i64 dy = sign_extended(y - other.y);
        const u64 squared = to_u64(dx * dx + dy * dy);
        const u32 entry = gaussian_entry(squared, a.domain.bits);
        const i64 weight =
            gaussian_weight(to_i32(AT(weights, entry)), to_i32(AT(weights, entry + 1u)),
                            gaussian_rest(squared, a.domain.bits));
        pull.x += weight * dx;
        pull.y += weight * dy;
    }
    return pull;
}

// The forces of the samples in a row of cells at most `reach` columns from `column`. The row's
// image makes y relative to it; each image of the columns makes x so.
BODY Pull pull_of_row(MEMORY const DescentArguments a, const Pull before, const u32 row,
                      const u32 column, const u32 reach, const u32 x, const u32 y) {
    Pull pull = before;
    const u32 cells = row * a.domain.columns;
    const u32 images = a.domain.wraps != 0u ? reach / a.domain.columns + 1u : 0u;
    // The first column in reach, as the image `images` to the left has it.
    i32 from = to_i32(column) - to_i32(reach) + to_i32(images * a.domain.columns);
    u32 at = x + images * a.domain.width;
    const i32 last = to_i32(a.domain.columns) - 1;
    for (u32 image = 0u; image <= 2u * images; ++image) {
        const i32 first = max(from, 0);
        const i32 end = min(from + to_i32(2u * reach), last);
        if (first <= end)
            pull = pull_of_run(ON a, pull, cell_begin(ON a, cells + to_u32(first)),
                               cell_begin(ON a, cells + to_u32(end) + 1u), at, y);
        from -= to_i32(a.domain.columns);
        at -= a.domain.width;
    }
    return pull;
}

BODY Pull pull_of_rows(MEMORY const DescentArguments a, const u32 x, const u32 y) {
    Pull pull;
    pull.x = 0;
    pull.y = 0;
    const u32 column = gaussian_cell(x, a.domain.columns, a.domain.width);
    const u32 own = gaussian_cell(y, a.domain.rows, a.domain.height);
    const u32 reach = a.domain.row_reach;
    const u32 images = a.domain.wraps != 0u ? reach / a.domain.rows + 1u : 0u;
    for (u32 k = 0u; k <= 2u * reach; ++k) {
        // The row as the image `images` below has it.
        const i32 above = to_i32(own + images * a.domain.rows + k) - to_i32(reach);
        const i32 image = above / to_i32(a.domain.rows);
        const i32 row = above - image * to_i32(a.domain.rows);
        if (above < 0 || (a.domain.wraps == 0u && image > 0)) continue;
        const u32 away = k < reach ? reach - k : k - reach;
        pull = pull_of_row(ON a, pull, to_u32(row), column, AT(column_reaches, away), x,
                           y + (images - to_u32(image)) * a.domain.height);
    }
    return pull;
}

// What a table along an axis has at a distance from an edge; `begin` is where it begins.
BODY i64 at_edge(MEMORY const DescentArguments a, const u32 begin, const u32 distance) {
    const u32 entry = begin + gaussian_edge_entry(distance, a.domain.bits);
    return gaussian_edge_value(to_i32(AT(edges, entry)), to_i32(AT(edges, entry + 1u)), distance,
                               a.domain.bits);
}

BODY Pull pull_of_edges(MEMORY const DescentArguments a, const u32 x, const u32 y) {
    Pull pull;
    const u32 right = a.domain.width - x;
    const u32 top = a.domain.height - y;
    const u32 areas = GAUSSIAN_EDGE_ENTRIES + 2u;
    pull.x =
        gaussian_edge_force(at_edge(ON a, 0u, x) - at_edge(ON a, 0u, right),
                            at_edge(ON a, areas, y) + at_edge(ON a, areas, top), a.domain.bits);
    pull.y =
        gaussian_edge_force(at_edge(ON a, 0u, y) - at_edge(ON a, 0u, top),
                            at_edge(ON a, areas, x) + at_edge(ON a, areas, right), a.domain.bits);
    return pull;
}

BODY void serve_descend(MEMORY const DescentArguments a, const u32 item) {
    const u32 end = min((item + 1u) * a.chunk, a.domain.samples);
    const u32 bits = a.domain.bits;
    for (u32 i = item * a.chunk; i < end; ++i) {
        Mover mover = LOAD(Mover, sorted_movers, i);
        Pull pull = pull_of_rows(ON a, mover.x, mover.y);
        if (a.domain.wraps == 0u) {
            const Pull edges = pull_of_edges(ON a, mover.x, mover.y);
            pull.x += edges.x;
            pull.y += edges.y;
        }
        mover.momentum_x = gaussian_momentum(mover.momentum_x, pull.x, bits);
        mover.momentum_y = gaussian_momentum(mover.momentum_y, pull.y, bits);
        mover.x =
            gaussian_place(mover.x, mover.momentum_x, a.pace, a.domain.width, a.domain.wraps, bits);
        mover.y = gaussian_place(mover.y, mover.momentum_y, a.pace, a.domain.height, a.domain.wraps,
                                 bits);
        STORE(movers, i, mover);
        AT(mover_ids, i) = AT(sorted_ids, i);
    }
    CHECK_TURNS(a.domain.samples, FAILED_DESCEND);
}
