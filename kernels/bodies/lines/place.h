// The x of a candidate as its conflicts count it. In lines the chord on the candidate's own line
// counts, so it is the x of the line.

BODY u32 place_of(const DrawArguments a, const u32x4 candidate) {
    const u32 middle = candidate.z * a.g.strip_width + a.g.strip_width / 2u;
    return a.g.rule != RULE_OF_LINES ? candidate.x : middle;
}
