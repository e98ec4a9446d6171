// The body of scan: prefix sums within blocks. Each count is replaced by the sum of the counts
// before it in its block; sums[to + block] becomes the sum of the block. The host launches it for
// counts[], then for the sums of blocks in sums[], then for the sums of these in tops[], whose sum
// is the total.

BODY void serve_scan(MEMORY const ScanArguments a, const u32 item) {
    const u32 begin = item * a.block;
    if (item > 0u && begin >= a.count) return;
    const u32 end = begin + min(a.block, a.count - begin);
    u32 sum = 0u;
    for (u32 i = begin; i < end; ++i) {
        const u32 value = AT(counts, i);
        AT(counts, i) = sum;
        sum += value;
    }
    AT(sums, a.to + item) = sum;
    CHECK_TURNS(a.count, FAILED_REFINE);
}
