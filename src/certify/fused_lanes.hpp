// For which machines are the quick answers about one pair of shapes compiled?  For those with AVX2 and fused
// multiply-adds, four lanes at once, and once more for all others.
//
// Included before foreach_target.h by the files that Highway compiles for both.  PLUMB_BY_LANES(space, ask(...)) is the
// answer of space::<target>::ask for the machine at hand.
// Not by Highway's dispatch, whose inline index counts the targets of all files: these are compiled for fewer.
// Source: RTCD 13.7.
// Cost: a branch that is always predicted.
#pragma once

#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/targets.h>

#include "certify/batch/chosen_target.hpp"

#if (HWY_TARGETS & HWY_AVX2) != 0 && HWY_STATIC_TARGET != HWY_AVX2
namespace plumb::certify::fused_lanes {
inline const bool are_there = (certify::batch::targets_or_all() & (HWY_AVX2 | HWY_AVX3)) != 0;
}
#define PLUMB_BY_LANES(space, ...) \
  (plumb::certify::fused_lanes::are_there ? space::N_AVX2::__VA_ARGS__ : space::HWY_NAMESPACE::__VA_ARGS__)
#else
#define PLUMB_BY_LANES(space, ...) (space::HWY_NAMESPACE::__VA_ARGS__)
#endif
