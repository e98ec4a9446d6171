// Where a candidate lies in space. Its home is the block of its bin.

BODY Position place_of(MEMORY const u32 i, const Candidate candidate) {
    const Position at = {to_i32(candidate.x), to_i32(candidate.y), to_i32(AT(heights, i))};
    return at;
}
