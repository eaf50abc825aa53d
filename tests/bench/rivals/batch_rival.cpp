#include "bench/rivals/batch_rival.hpp"

#include <algorithm>
#include <array>

#include "plumb/certify/detail/filter_stage.hpp"
#include "plumb/predicates/manifest.hpp"

namespace plumb::bench {
namespace {

template <Formula F>
[[gnu::always_inline]] inline Coordinates<F> coordinates_of(const double* const* at, std::size_t i) {
  return [&]<std::size_t... K>(std::index_sequence<K...>) __attribute__((always_inline)) {
    return Coordinates<F>{at[K][i]...};
  }
  (std::make_index_sequence<arity<F>>());
}

template <Formula F>
[[gnu::always_inline]] inline void bare_loop(const double* const* at, std::size_t n, signed char* __restrict out) {
  std::array<const double*, arity<F>> mine;
  std::copy_n(at, mine.size(), mine.begin());
  for (std::size_t i = 0; i < n; ++i) {
    const double value = F{}(coordinates_of<F>(mine.data(), i));
    out[i] = static_cast<signed char>((value > 0) - (value < 0));
  }
}

template <Formula F>
[[gnu::always_inline]] inline void filtered_loop(const double* const* at, std::size_t n, signed char* __restrict out) {
  std::array<const double*, arity<F>> mine;
  std::copy_n(at, mine.size(), mine.begin());
  for (std::size_t i = 0; i < n; ++i) {
    out[i] = static_cast<signed char>(magnitude_filter<F>(coordinates_of<F>(mine.data(), i)));
  }
}

#if defined(__x86_64__)
#define PLUMB_LOOPS(set, options)                                                                       \
  template <Formula F>                                                                                  \
  struct set {                                                                                          \
    [[gnu::flatten, gnu::target(options)]] static void bare(const double* const* at, std::size_t n,     \
                                                            signed char* out) {                         \
      bare_loop<F>(at, n, out);                                                                         \
    }                                                                                                   \
    [[gnu::flatten, gnu::target(options)]] static void filtered(const double* const* at, std::size_t n, \
                                                                signed char* out) {                     \
      filtered_loop<F>(at, n, out);                                                                     \
    }                                                                                                   \
  };
PLUMB_LOOPS(Sse2, "sse2")
PLUMB_LOOPS(Avx2, "avx2")
#if defined(__clang__)
PLUMB_LOOPS(Avx512, "avx512f,avx512dq,avx512vl,avx512bw")
#else
PLUMB_LOOPS(Avx512, "avx512f,avx512dq,avx512vl,avx512bw,prefer-vector-width=512")
#endif
#undef PLUMB_LOOPS
#endif

template <Formula F>
void append(std::vector<Loop>& loops) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw")) {
    loops.push_back({F::name, "AVX-512", Avx512<F>::bare, Avx512<F>::filtered});
  }
  if (__builtin_cpu_supports("avx2")) loops.push_back({F::name, "AVX2", Avx2<F>::bare, Avx2<F>::filtered});
  loops.push_back({F::name, "SSE", Sse2<F>::bare, Sse2<F>::filtered});
#else
  loops.push_back({F::name, "baseline", bare_loop<F>, filtered_loop<F>});
#endif
}

}  // namespace

std::vector<Loop> compiled_loops() {
  std::vector<Loop> loops;
  append<predicates::Orient2d>(loops);
  append<predicates::Orient3d>(loops);
  append<predicates::InCircle>(loops);
  append<predicates::InSphere>(loops);
  return loops;
}

}  // namespace plumb::bench
