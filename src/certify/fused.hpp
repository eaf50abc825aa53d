// Does this processor multiply and add at once?  For files whose functions are compiled once for those that do, and
// once for all others.
//
// PLUMB_WITH_FMA before a function compiles it and what it calls for such processors, PLUMB_WITHOUT for all; has_fma
// tells which to call.  Both must give the same answer (arith/twofold.hpp).
// Cost: a branch that is always predicted.
#pragma once

namespace plumb {

#if defined(__x86_64__) && !defined(__FMA__)
#define PLUMB_WITH_FMA [[gnu::target("fma"), gnu::noinline, gnu::flatten]]
inline const bool has_fma = __builtin_cpu_supports("fma") != 0;
#else
#define PLUMB_WITH_FMA [[gnu::noinline, gnu::flatten]]
#ifdef __FP_FAST_FMA
inline constexpr bool has_fma = true;
#else
inline constexpr bool has_fma = false;
#endif
#endif
#define PLUMB_WITHOUT [[gnu::noinline, gnu::flatten]]

}  // namespace plumb
