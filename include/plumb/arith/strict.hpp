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
#elif defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "plumb: -ffinite-math-only removes the tests that catch overflow and NaN; compile without it"
#elif defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "plumb: doubles must be evaluated as doubles (on 32-bit x86 use -msse2 -mfpmath=sse)"
#endif

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53);

// Part of -ffast-math by another name.  GCC says each by a macro; Clang 14 none of these, and check_environment() looks
// for what they do to the code that calls it.
#if defined(__FAST_MATH__)
#elif defined(__ASSOCIATIVE_MATH__)
#error "plumb: -fassociative-math (of -funsafe-math-optimizations) reorders the sums of the proofs; compile without it"
#elif defined(__RECIPROCAL_MATH__)
#error "plumb: -freciprocal-math (of -funsafe-math-optimizations) rounds a quotient twice; compile without it"
#elif defined(__NO_SIGNED_ZEROS__)
#error "plumb: -fno-signed-zeros (of -funsafe-math-optimizations) changes the bits of answers; compile without it"
#elif defined(__GCC_IEC_559) && __GCC_IEC_559 == 0
#error "plumb: an option takes IEEE-754 arithmetic away (GCC says so by __GCC_IEC_559); compile without it"
#endif
