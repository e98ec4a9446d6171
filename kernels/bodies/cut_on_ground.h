// The body of cut on a ground: cuts places, or their parts, by the samples listed for them. Comes
// after remnants.h.

// counts[strip] is how many pieces are left of a strip, none or one, and pieces[strip] the piece;
// an end of 0 tells of none, NO_SAMPLE that there may be several. Those few are left to
// cut_several, as items in lockstep would all take the time each time. Does nothing while admission
// is unsettled.
BODY void serve_cut_on_ground(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end; ++number) {
        const Rest rest = rest_of(ON a, strip_of(ON number));
        const bool is_left = rest.low < rest.high;
        AT(counts, number) = is_left ? 1u : 0u;
        const u32 piece_end = rest.has_inside ? NO_SAMPLE : rest.high;
        AT(pieces, number) = U32X2(rest.low, is_left ? piece_end : 0u);
        if (is_left && rest.has_inside) AT(several, ATOMIC_ADD(several_count, 0, 1u)) = number;
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}
