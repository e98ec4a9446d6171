// The body of insert: puts the round's samples where screen finds them, and empties the lists of
// candidates that were made for decide. Does nothing while a draw is undecided. Comes after a file
// that has list_of(), the number of a candidate's list, and insert_sample().

BODY void serve_insert(MEMORY const DrawArguments a, const u32 item) {
    if (AT(report, a.last_pass) != 0u) return;
    const u32 begin = a.first + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    for (u32 i = begin; i < end; ++i) {
        const u32 status = AT(statuses, i);
        if (status == STATUS_COVERED) continue;  // it was never listed
        const Candidate candidate = LOAD(Candidate, candidates, i);
        const u32 list = list_of(a, candidate);
        AT(cell_heads, list) = NO_SAMPLE;
        if (status == STATUS_ADMITTED) insert_sample(ON a, i, candidate, list);
    }
}
