// The sum of the counts before a count, once they were scanned in three levels (scan.h).

BODY u32 sum_before(MEMORY const u32 number, const u32 block_bits) {
    return AT(counts, number) + AT(sums, number >> block_bits) +
           AT(tops, number >> 2u * block_bits);
}
