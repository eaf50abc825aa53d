// Is the machine, and the code around the call, as the proofs assume?
//
// Laws: checks, never changes.  What concerns compiled code (contraction, fast-math) is looked at in the translation
// unit that calls check_environment(), since the hot paths are inline there; the rest is the state of this thread.
// Source: RTCD 11.2.3, docs/proof.md "Assumptions".
// Cost: a microsecond.
#pragma once

#include <string>
#include <vector>

#include "plumb/arith/strict.hpp"

namespace plumb {

struct Environment {
  bool rounds_to_nearest;                     // the rounding mode of this thread
  bool keeps_subnormals;                      // neither flush-to-zero nor denormals-are-zero
  bool contracts;                             // the caller's a * b + c is fused (needs -ffp-contract=off)
  bool fast_math;                             // the caller's code may reorder or drop operations
  std::string version;                        // of the library
  std::string compiler;                       // that built the library
  std::string build;                          // its options
  std::vector<std::string> instruction_sets;  // of this processor, those the library or its users may profit from

  /// All assumptions hold.
  [[nodiscard]] bool sound() const { return rounds_to_nearest && keeps_subnormals && !contracts && !fast_math; }
};

namespace certify::environment {

Environment inspect(bool contracts, bool fast_math);

/// Does this thread round to nearest and keep subnormals?  Tens of ns; certify/checked.hpp asks it before decisions.
bool thread_is_sound();

// Internal linkage on purpose: each translation unit must answer for its own flags.
[[maybe_unused]] static bool contracts_here() {
  const volatile double a = 1 + 0x1p-30, minus_square = -(1 + 0x1p-29);
  const double x = a, y = minus_square;
  return x * x + y != 0;  // fused, the square keeps its last bit 2^-60
}
[[maybe_unused]] static bool fast_math_here() {
  const volatile double large = 0x1p53, one = 1, nan = large * 0x1p1000 * 0 / (large - large);
  const volatile double five = 5, minus_zero = -0.0, infinite = large * 0x1p1000;
  const double l = large, o = one, n = nan, f = five, z = minus_zero, i = infinite;
  const bool reassociates = (l + o) - l != 0, by_reciprocals = f / 49 != 0x1.a1f58d0fac688p-4;  // exact; rounded twice
  const bool has_no_nan = n == n, has_no_infinity = !__builtin_isinf(i), drops_zeros = __builtin_signbit(z + 0.0) != 0;
  return reassociates || by_reciprocals || has_no_nan || has_no_infinity || drops_zeros;
}

}  // namespace certify::environment

[[maybe_unused]] static Environment check_environment() {
  return certify::environment::inspect(certify::environment::contracts_here(), certify::environment::fast_math_here());
}

}  // namespace plumb
