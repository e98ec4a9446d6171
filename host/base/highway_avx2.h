// Highway for a file of inner loops, which Highway includes once more, compiled for AVX2; the rest
// of the library is not. The file names itself in HWY_TARGET_INCLUDE before it includes this.
//
// Highway's own choice at run time is in a shared library, which a wheel would have to carry.
// has_avx2() replaces it. AVX-512 is not faster here.
//
// There is no include guard around Highway, which is included for each target.

// Highway's checks in debug builds are in its shared library, too.
#undef HWY_IS_DEBUG_BUILD
#define HWY_IS_DEBUG_BUILD 0
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef LACUNA_HIGHWAY_AVX2_H
#define LACUNA_HIGHWAY_AVX2_H

namespace lacuna {

// Whether the processor has the features that Highway requires for AVX2.
inline bool has_avx2() {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma");
}

}  // namespace lacuna

#endif
