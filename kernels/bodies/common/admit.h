// The body of admit: a candidate becomes a sample unless an earlier sample of its round conflicts
// with it. Earlier means by draw, whatever the order of the work. It is included after a file
// that has decide(), which finds conflicts.

// Number of comparisons after which an item leaves its other candidates to the next pass. Without
// this limit its loops could take more turns than lavapipe allows (failure.h).
#define MOST_RIVALS 2048u
// A candidate that waits for another one is tried again in the same pass: most others are decided
// by then.
#define TRIES 2u

// Tries to decide the candidates [begin, end). Returns how many stay undecided, at least. The first
// half of outcomes[] has a bit for each sample, by the order of its draw.
BODY u32 decide_all(MEMORY const DrawArguments a, const u32 begin, const u32 end) {
    u32 left = 0u;
    u32 looks = 0u;
    for (u32 i = begin; i < end; ++i) {
        // A loop of its own: items in lockstep skip together, then decide together.
        while (i < end && LOOK_AT(statuses, i) != STATUS_UNDECIDED) ++i;
        if (i == end) break;
        if (looks > MOST_RIVALS) return left + 1u;
        const Candidate candidate = LOAD(Candidate, candidates, i);
        const u32 decided = decide(ON a, i, candidate);
        const u32 status = decided % 4u;
        looks += decided / 4u;
        if (status == STATUS_UNDECIDED) {
            ++left;
            continue;
        }
        ATOMIC_SET(statuses, i, status);
        if (status == STATUS_ADMITTED)
            ATOMIC_OR(outcomes, candidate.order / 32u, 1u << candidate.order % 32u);
    }
    return left;
}

// One pass over all candidates. report[pass] is 0 if no candidate stays undecided; later passes
// then do nothing.
BODY void serve_admit(MEMORY const DrawArguments a, const u32 item) {
    if (a.pass > 0u && AT(report, a.pass - 1u) == 0u) return;
    const u32 begin = a.first + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    u32 left = 1u;
    for (u32 k = 0u; k < TRIES && left > 0u; ++k) left = decide_all(ON a, begin, end);
    if (left > 0u) ATOMIC_ADD(report, a.pass, left);
    CHECK_TURNS(a.g.height, FAILED_ADMIT);
}
