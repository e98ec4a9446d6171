// The body of screen: decides the candidates that earlier samples cover: of earlier rounds or, in
// later parts of a round, of earlier parts. Comes after a file that has is_covered and leave_open.
#include "portable/bits.h"

// If a.status is STATUS_UNDECIDED, candidates are only listed. If it is STATUS_COVERED, these are
// all draws of the round, and the second half of outcomes[] has a bit for each covered draw.
BODY void serve_screen(MEMORY const DrawArguments a, const u32 item) {
    const u32 begin = a.first + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    for (u32 i = begin; i < end; ++i) {
        if (a.status != STATUS_UNDECIDED && AT(statuses, i) == STATUS_UNDECIDED &&
            is_covered(ON a, i)) {
            AT(statuses, i) = a.status;
            const u32 order = LOAD(Candidate, candidates, i).order;
            if (a.status == STATUS_COVERED)
                ATOMIC_OR(outcomes, words_of_column(a.count) + order / 32u, 1u << order % 32u);
        } else {
            leave_open(ON a, i);
        }
    }
    CHECK_TURNS(a.g.height, FAILED_ADMIT);
}
