// Where the samples of a cell begin: the sums of scan.

BODY u32 cell_begin(MEMORY const DescentArguments a, const u32 cell) {
    return AT(counts, cell) + AT(sums, cell >> a.block_bits);
}
