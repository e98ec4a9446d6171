// The body of count_samples: counts the samples of each 32 orders, for list_samples. Does nothing
// while a draw is undecided.
#include "portable/bits.h"

// outcomes[] has a bit for each sample, then a bit for each covered draw. counts[] has the numbers
// of boxes first, so that one scan adds up both.
BODY void serve_count_samples(MEMORY const SampleArguments a, const u32 item) {
    if (AT(report, a.last_pass) != 0u) return;
    const u32 words = words_of_column(a.draws);
    const u32 end = min((item + 1u) * a.chunk, words);
    u32 samples = 0u;
    u32 covered = 0u;
    for (u32 i = item * a.chunk; i < end; ++i) {
        const u32 count = count_bits(AT(outcomes, i));
        AT(counts, a.counts_before + i) = count;
        samples += count;
        covered += count_bits(AT(outcomes, words + i));
    }
    if (samples > 0u) ATOMIC_ADD(report, SAMPLES_WORD, samples);
    if (covered > 0u) ATOMIC_ADD(report, COVERED_WORD, covered);
}
