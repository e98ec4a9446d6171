// Puts a sample in space into the list of its block, whose candidates are another list.

BODY u32 list_of(const DrawArguments a, const Candidate candidate) {
    return candidate.home;
}

// a.room is the number of samples before the round.
BODY void insert_sample(MEMORY const DrawArguments a, const u32 i, const Candidate candidate,
                        const u32 block) {
    const u32 number = a.room + ATOMIC_ADD(report, ENTRIES_WORD, 1u);
    const Listed one = {to_i32(candidate.x), to_i32(candidate.y), to_i32(AT(heights, i)),
                        ATOMIC_SET(sample_heads, block, number)};
    STORE(listed, number, one);
}
