#include "plumb/certify/environment.hpp"

#include <cstdio>
#include <cstdlib>
#include <limits>

#include "plumb/certify/checked.hpp"

namespace plumb::certify::environment {
namespace {

std::vector<std::string> instruction_sets() {
  std::vector<std::string> found;
#if defined(__x86_64__)
  // The builtin takes literals only.
#define PLUMB_IF_SUPPORTED(set) \
  if (__builtin_cpu_supports(set)) found.emplace_back(set)
  PLUMB_IF_SUPPORTED("sse2");
  PLUMB_IF_SUPPORTED("sse4.2");
  PLUMB_IF_SUPPORTED("avx");
  PLUMB_IF_SUPPORTED("avx2");
  PLUMB_IF_SUPPORTED("fma");
  PLUMB_IF_SUPPORTED("bmi2");
  PLUMB_IF_SUPPORTED("avx512f");
  PLUMB_IF_SUPPORTED("avx512dq");
  PLUMB_IF_SUPPORTED("avx512vl");
#undef PLUMB_IF_SUPPORTED
#elif defined(__aarch64__)
  found.emplace_back("neon");
#endif
  return found;
}

std::string compiler() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#elif defined(__GNUC__)
  return "GCC " __VERSION__;
#else
  return "unknown";
#endif
}

std::string build() {
  std::string s;
#ifdef __OPTIMIZE__
  s += "optimized";
#else
  s += "not optimized";
#endif
#ifdef PLUMB_CHECKED
  s += ", checked";
#endif
#ifdef __FMA__
  s += ", fma";
#endif
#ifdef __SANITIZE_ADDRESS__
  s += ", address sanitizer";
#endif
  return s;
}

// Half an ulp more and half an ulp less than one tell the four rounding modes apart.
bool rounds_to_nearest() {
  const volatile double one = 1, small = 0x1p-60;
  const double up = one + small, down = one - small, minus = -one - small;
  return up == 1 && down == 1 && minus == -1;
}

bool keeps_subnormals() {
  const volatile double least_normal = std::numeric_limits<double>::min(), half = 0.5;
  const volatile double subnormal = least_normal * half;      // flushed when results are
  const volatile double restored = subnormal + least_normal;  // its operand dropped when inputs are
  return subnormal > 0 && restored > least_normal;
}

}  // namespace

void require_sound_thread() {
  if (thread_is_sound()) return;
  std::fputs("plumb: this thread does not round to nearest, or flushes subnormals; see check_environment()\n", stderr);
  std::abort();
}

bool thread_is_sound() { return rounds_to_nearest() && keeps_subnormals(); }

Environment inspect(bool contracts, bool fast_math) {
  return {rounds_to_nearest(), keeps_subnormals(), contracts, fast_math,
          PLUMB_VERSION,       compiler(),         build(),   instruction_sets()};
}

}  // namespace plumb::certify::environment
