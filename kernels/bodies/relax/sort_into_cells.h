// The body of sort_into_cells: puts each sample where its cell and its rank say.
#include "bodies/relax/cell_begin.h"
#include "bodies/relax/cell_of.h"

BODY void serve_sort_into_cells(MEMORY const DescentArguments a, const u32 item) {
    const u32 end = min((item + 1u) * a.chunk, a.domain.samples);
    for (u32 i = item * a.chunk; i < end; ++i) {
        const Mover mover = LOAD(Mover, movers, i);
        const u32 to = cell_begin(ON a, cell_of(a, mover.x, mover.y)) + AT(ranks, i);
        STORE(sorted_movers, to, mover);
        AT(sorted_ids, to) = AT(mover_ids, i);
    }
}
