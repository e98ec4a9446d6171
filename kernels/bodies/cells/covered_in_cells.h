// What screen asks in mode cells: whether samples block a candidate's lattice point.
BODY bool is_covered(MEMORY const DrawArguments a, const u32 i) {
    const Candidate candidate = LOAD(Candidate, candidates, i);
    const u32 word = AT(bits, candidate.x * a.g.capacity + candidate.y / 32u);
    return (word >> (candidate.y % 32u) & 1u) == 0u;
}

BODY void leave_open(MEMORY const DrawArguments a, const u32 i) {}
