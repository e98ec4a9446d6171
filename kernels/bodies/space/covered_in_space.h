// In space, for the kernel screen: whether an earlier sample covers a candidate.
#include "bodies/space/around.h"
#include "bodies/space/candidate.h"

BODY bool is_covered(MEMORY const DrawArguments a, const u32 i) {
    const Candidate candidate = LOAD(Candidate, candidates, i);
    const Position at = place_of(ON i, candidate);
    const Around around = blocks_around(ON candidate.home);
    for (u32 k = 0u; k < around.count; ++k) {
        const NearCell near = block_around(ON around, k);
        if (!near.exists) continue;
        u32 number = AT(sample_heads, near.number);
        while (number != NO_SAMPLE) {
            const Listed one = LOAD(Listed, listed, number);
            if (squared_distance(listed_at(one, near), at) < a.g.radius_squared) return true;
            number = one.next;
        }
    }
    return false;
}

// Lists the candidate in its block, for decide.
BODY void leave_open(MEMORY const DrawArguments a, const u32 i) {
    if (a.is_listed == 0u || AT(statuses, i) != STATUS_UNDECIDED) return;
    const u32 block = LOAD(Candidate, candidates, i).home;
    AT(next_candidates, i) = ATOMIC_SET(cell_heads, block, i);
}
