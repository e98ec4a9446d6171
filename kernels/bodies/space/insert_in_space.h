// The body of insert in space: puts the round's samples into the lists of their blocks, and empties
// the blocks' lists of candidates. Does nothing while a draw is undecided.

// a.room is the number of samples before the round.
BODY void serve_insert_in_space(MEMORY const DrawArguments a, const u32 item) {
    if (AT(report, a.last_pass) != 0u) return;
    const u32 begin = a.first + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    for (u32 i = begin; i < end; ++i) {
        const u32 status = AT(statuses, i);
        if (status == STATUS_COVERED) continue;  // it was never listed
        const Candidate candidate = LOAD(Candidate, candidates, i);
        AT(cell_heads, candidate.home) = NO_SAMPLE;
        if (status != STATUS_ADMITTED) continue;
        const u32 number = a.room + ATOMIC_ADD(report, ENTRIES_WORD, 1u);
        const Listed one = {to_i32(candidate.x), to_i32(candidate.y), to_i32(AT(heights, i)),
                            ATOMIC_SET(sample_heads, candidate.home, number)};
        STORE(listed, number, one);
    }
}
