// The body of list_samples: writes the samples of the round in the order of their draws, after what
// results[] has of the bins. Does nothing while a draw is undecided. Comes after a file that has
// write_sample().
#include "bodies/common/sums.h"

BODY void serve_list_samples(MEMORY const SampleArguments a, const u32 item) {
    if (AT(report, a.last_pass) != 0u) return;
    const u32 bins = AT(report, TOTAL_WORD) - AT(report, SAMPLES_WORD);
    // The host sees that the pieces of boxes do not fit, and launches again.
    if (bins > a.room) return;
    const u32 first = (a.bins != 0u ? a.bins : bins) * a.words_of_bin;
    const u32 end = min((item + 1u) * a.chunk, a.draws);
    for (u32 i = item * a.chunk; i < end; ++i) {
        if (AT(statuses, i) != STATUS_ADMITTED) continue;
        const Candidate admitted = LOAD(Candidate, candidates, i);
        const u32 word = admitted.order / 32u;
        const u32 below = (1u << admitted.order % 32u) - 1u;
        const u32 rank = sum_before(ON a.counts_before + word, a.block_bits) - bins +
                         count_bits(AT(outcomes, word) & below);
        write_sample(ON first + SAMPLE_WORDS * rank, i, admitted);
    }
}
