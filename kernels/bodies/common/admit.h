// The body of admit: a candidate becomes a sample unless an earlier sample of its round conflicts
// with it. Earlier means by draw, whatever the order of the work. It is included after decide.h or
// decide_with_field.h, which find conflicts.

// Number of comparisons after which an item leaves its other candidates to the next pass. Without
// this limit its loops could take more turns than lavapipe allows (failure.h).
#define MOST_RIVALS 2048u

// One pass over all candidates. undecided[pass] is 0 if no candidate stays undecided; later passes
// then do nothing. The host finds the result of a draw in samples[order].
BODY void serve_admit(MEMORY const DrawArguments a, const u32 item) {
    if (a.pass > 0u && AT(undecided, a.pass - 1u) == 0u) return;
    const u32 begin = a.first + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    u32 left = 0u;
    u32 looks = 0u;
    for (u32 i = begin; i < end; ++i) {
        // A loop of its own: items in lockstep skip together, then decide together.
        while (i < end && LOOK_AT(statuses, i) != STATUS_UNDECIDED) ++i;
        if (i == end) break;
        if (looks > MOST_RIVALS) {
            ++left;
            break;
        }
        const u32x4 candidate = AT(candidates, i);
        const u32 decided = decide(ON a, i, candidate);
        const u32 status = decided % 4u;
        looks += decided / 4u;
        if (status == STATUS_UNDECIDED) {
            ++left;
            continue;
        }
        ATOMIC_SET(statuses, i, status);
        AT(samples, candidate.w) =
            status == STATUS_ADMITTED ? U32X2(candidate.x, candidate.y) : U32X2(NO_SAMPLE, status);
    }
    if (left > 0u) ATOMIC_ADD(undecided, a.pass, left);
    CHECK_TURNS(a.g.height, FAILED_ADMIT);
}
