// In space: whether an earlier sample of its round is closer to a candidate than the radius.
// cell_heads[] has the first candidate of the round in each block.
#include "bodies/space/around.h"
#include "bodies/space/candidate.h"

// Returns what bodies/lines/decide.h returns.
BODY u32 decide(MEMORY const DrawArguments a, const u32 i, const Candidate candidate) {
    const Position at = place_of(ON i, candidate);
    const Around around = blocks_around(ON candidate.home);
    bool waits = false;
    u32 looks = 0u;
    for (u32 k = 0u; k < around.count; ++k) {
        const NearCell near = block_around(ON around, k);
        if (!near.exists) continue;
        u32 number = AT(cell_heads, near.number);
        while (number != NO_SAMPLE) {
            ++looks;
            const u32 one = number;
            number = AT(next_candidates, one);
            const Candidate other = LOAD(Candidate, candidates, one);
            if (other.order >= candidate.order) continue;
            const Position there = moved(place_of(ON one, other), near.shift);
            if (squared_distance(there, at) >= a.g.radius_squared) continue;
            const u32 status = ATOMIC_OR(statuses, one, 0u);
            if (status == STATUS_ADMITTED) return STATUS_REJECTED + 4u * looks;
            waits = waits || status == STATUS_UNDECIDED;
        }
    }
    return (waits ? STATUS_UNDECIDED : STATUS_ADMITTED) + 4u * looks;
}
