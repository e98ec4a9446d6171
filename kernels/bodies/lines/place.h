// Where candidates lie: their cell of the sample grid, and their x.

BODY u32 cell_of_candidate(const Geometry g, const Candidate candidate) {
    return candidate.x / g.grid_side * g.grid_rows + candidate.y / g.grid_side;
}

// The x of a candidate as its conflicts count it. In lines the chord on the candidate's own line
// counts, so it is the x of the line.

BODY u32 place_of(const DrawArguments a, const Candidate candidate) {
    const u32 middle = candidate.home * a.g.strip_width + a.g.strip_width / 2u;
    return a.g.rule != RULE_OF_LINES ? candidate.x : middle;
}
