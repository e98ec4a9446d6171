// Functions that are compiled twice if the loader can choose: most processors take four doubles, or
// eight floats, at once. Their results are exact in both versions. Sanitizers start too late for
// the loader's choice.
#pragma once

#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define LACUNA_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define LACUNA_WIDE
#endif
