// With a radius field: whether an earlier sample of its round conflicts with a candidate. All
// candidates that could are visitors of the candidate's block (bodies/exact/reach.h).
#include "bodies/exact/ellipses.h"

// Returns what decide.h returns.
BODY u32 decide(MEMORY const DrawArguments a, const u32 i, const Candidate candidate) {
    const Sized one = {candidate.x, candidate.y, AT(candidate_radii, i)};
    bool waits = false;
    u32 looks = 0u;
    u32 number = AT(visitor_heads, candidate.home);
    while (number != NO_SAMPLE) {
        const Visitor visitor = LOAD(Visitor, visitors, number);
        number = visitor.next;
        ++looks;
        const Candidate other = LOAD(Candidate, candidates, visitor.candidate);
        if (other.order >= candidate.order) continue;
        const u32 radius = AT(candidate_radii, visitor.candidate);
        if (!are_in_conflict(ON a.g, other.x, other.y, radius, one)) continue;
        const u32 status = ATOMIC_OR(statuses, visitor.candidate, 0u);
        if (status == STATUS_ADMITTED) return STATUS_REJECTED + 4u * looks;
        waits = waits || status == STATUS_UNDECIDED;
    }
    return waits ? STATUS_UNDECIDED + 4u * looks : STATUS_ADMITTED + 4u * looks;
}
