// Is this translation unit compiled as the proofs assume?  Refuses to compile where it plainly is not.
//
// Every filter rests on IEEE-754 doubles, each operation rounded once to nearest (docs/proof.md, "Assumptions").
// What the preprocessor cannot see (contraction, rounding mode, flush to zero) check_environment() looks for.
// Source: RTCD 11.2.
// Cost: none.
#pragma once

#include <cfloat>
#include <limits>

#include "plumb/predicates/standard.hpp"

#if defined(__FAST_MATH__)
#error "plumb: -ffast-math breaks the proofs behind every exact sign; compile without it"
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "plumb: -ffinite-math-only removes the tests that catch overflow and NaN; compile without it"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "plumb: doubles must be evaluated as doubles (on 32-bit x86 use -msse2 -mfpmath=sse)"
#endif

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53);
