// The body of screen with a radius field: finds the candidates that lie where no sample may lie, or
// that samples in the list of their block cover. These are samples of earlier rounds or, for later
// parts of a round, of earlier parts. Lists the others in survivors[] if a.is_listed.
#include "portable/conflict.h"

BODY bool is_covered(MEMORY const DrawArguments a, const u32x4 candidate, const u32 radius) {
    if (radius == 0u) return true;
    const Sized one = {candidate.x, candidate.y, radius};
    for (u32 number = AT(lists, candidate.z); number != NO_SAMPLE;) {
        const u32x4 entry = AT(entries, number);
        const Sized other = {entry.x, entry.y, entry.z};
        if (conflicts(other, one, a.g.period_x, a.g.period_y)) return true;
        number = entry.w;
    }
    return false;
}

// samples[order] tells the host the draw's status.
BODY void serve_screen_with_field(MEMORY const DrawArguments a, const u32 item) {
    const u32 begin = a.first + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    for (u32 i = begin; i < end; ++i) {
        if (AT(statuses, i) != STATUS_UNDECIDED) continue;
        const u32x4 candidate = AT(candidates, i);
        if (is_covered(ON a, candidate, AT(candidate_radii, i))) {
            AT(statuses, i) = a.status;
            AT(samples, candidate.w) = U32X2(NO_SAMPLE, a.status);
        } else if (a.is_listed != 0u) {
            AT(survivors, ATOMIC_ADD(survivor_count, 0, 1u)) = i;
        }
    }
    CHECK_TURNS(a.g.height, FAILED_ADMIT);
}
