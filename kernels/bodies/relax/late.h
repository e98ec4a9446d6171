// Lists the number of a leaf that is processed later, because it has too many rivals.
BODY void leave_for_later(MEMORY const u32 leaf) {
    AT(late, ATOMIC_ADD(late_count, 0, 1u)) = leaf;
}
