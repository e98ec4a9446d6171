// What results[] has of a sample.

#define SAMPLE_WORDS 2u

BODY void write_sample(MEMORY const u32 to, const u32 i, const Candidate admitted) {
    AT(results, to) = admitted.x;
    AT(results, to + 1u) = admitted.y;
}
