// What screen asks with a radius field: whether a candidate lies where no sample may lie, or
// whether a sample in the list of its block covers it.
#include "bodies/exact/ellipses.h"

BODY bool is_covered(MEMORY const DrawArguments a, const u32 i) {
    const u32x4 candidate = AT(candidates, i);
    const u32 radius = AT(candidate_radii, i);
    if (radius == 0u) return true;
    const Sized one = {candidate.x, candidate.y, radius};
    for (u32 number = AT(lists, candidate.z); number != NO_SAMPLE;) {
        const u32x4 entry = AT(entries, number);
        if (are_in_conflict(ON a.g, entry.x, entry.y, entry.z, one)) return true;
        number = entry.w;
    }
    return false;
}

// Lists the candidate as a survivor, for reach, if the round has one part.
BODY void leave_open(MEMORY const DrawArguments a, const u32 i) {
    if (a.is_listed != 0u) AT(survivors, ATOMIC_ADD(report, SURVIVORS_WORD, 1u)) = i;
}
