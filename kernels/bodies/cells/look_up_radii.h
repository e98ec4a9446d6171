// The body of look_up_radii: in mode cells a candidate has the radius of its pixel.

BODY void serve_look_up_radii(MEMORY const DrawArguments a, const u32 item) {
    const u32 begin = a.first + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    for (u32 i = begin; i < end; ++i) {
        const Candidate candidate = LOAD(Candidate, candidates, i);
        const u32 pixel = AT(column_of, candidate.x) * a.rows + AT(row_of, candidate.y);
        AT(candidate_radii, i) = AT(pixel_radii, pixel);
    }
}
