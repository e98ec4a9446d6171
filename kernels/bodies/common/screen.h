// The body of screen: decides the candidates that earlier samples cover: of earlier rounds or, in
// later parts of a round, of earlier parts. Comes after a file that has is_covered and leave_open.

// The host reads the status of a covered draw from samples[order].
BODY void serve_screen(MEMORY const DrawArguments a, const u32 item) {
    const u32 begin = a.first + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    for (u32 i = begin; i < end; ++i) {
        if (AT(statuses, i) == STATUS_UNDECIDED && is_covered(ON a, i)) {
            AT(statuses, i) = a.status;
            AT(samples, AT(candidates, i).w) = U32X2(NO_SAMPLE, a.status);
        } else {
            leave_open(ON a, i);
        }
    }
    CHECK_TURNS(a.g.height, FAILED_ADMIT);
}
