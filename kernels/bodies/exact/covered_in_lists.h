// What screen asks with a radius field: whether a candidate lies where no sample may lie, or
// whether a sample in the list of its block covers it.
#include "bodies/exact/ellipses.h"

BODY bool is_covered(MEMORY const DrawArguments a, const u32 i) {
    const Candidate candidate = LOAD(Candidate, candidates, i);
    const u32 radius = AT(candidate_radii, i);
    if (radius == 0u) return true;
    const Sized one = {candidate.x, candidate.y, radius};
    for (u32 number = AT(lists, candidate.home); number != NO_SAMPLE;) {
        const Neighbour entry = LOAD(Neighbour, entries, number);
        if (are_in_conflict(ON a.g, entry.x, entry.y, entry.radius, one)) return true;
        number = entry.next;
    }
    return false;
}

// Lists the candidate as a survivor, for reach, if the round has one part.
BODY void leave_open(MEMORY const DrawArguments a, const u32 i) {
    if (a.is_listed != 0u) AT(survivors, ATOMIC_ADD(report, SURVIVORS_WORD, 1u)) = i;
}
