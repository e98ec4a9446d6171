// The body of measure: the least radius under each of the new places where it is not known yet.
// Comes after ground.h. Does nothing while admission is unsettled: then there are no new places.

BODY void serve_measure(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, min(AT(total, 0), a.room));
    for (u32 number = item * a.chunk; number < end; ++number)
        if (AT(new_origins, number).y == 0u)
            AT(new_origins, number).y = under(ON AT(new_places, number)).least;
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}
