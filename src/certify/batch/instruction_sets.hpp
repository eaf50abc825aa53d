// For which instruction sets are the filters compiled?  What each file of filters includes before foreach_target.h.
//
// SSSE3, AVX2 and AVX-512 on x86-64, NEON on Arm, and one case after the other; the best one that the processor has is
// taken when a batch is asked for.  SSE4 brings nothing to these filters; vectors of unknown length are not provided
// for.
#pragma once

#define HWY_DISABLED_TARGETS (HWY_SSE4 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
