// Leaves that are left for later, because they have too many rivals: by their numbers.
BODY void leave_for_later(MEMORY const u32 leaf) {
    AT(late, ATOMIC_ADD(late_count, 0, 1u)) = leaf;
}
