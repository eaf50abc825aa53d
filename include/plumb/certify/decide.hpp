// Adaptive precision: what is the sign of a formula at these coordinates, exactly?  The chain of stages.
//
// Laws: the answer is the sign of the exact value for all finite doubles; anything else throws NonFinite, naming the
// argument.  The order of the stages changes the time, never the answer.
// Source: docs/proof.md; the order and what is left out: docs/measurements.md, "Stages".
// Cost: the filter where it is sure; then as exact_stages.hpp says.
#pragma once

#include <type_traits>

#include "plumb/certify/accepted.hpp"
#include "plumb/certify/checked.hpp"
#include "plumb/certify/decision.hpp"
#include "plumb/certify/detail/exact_stages.hpp"
#include "plumb/certify/detail/filter_stage.hpp"
#include "plumb/certify/detail/long_filter.hpp"
#include "plumb/predicates/manifest.hpp"

namespace plumb {

/// Throws NonFinite for the first coordinate that is NaN or infinite: "orient2d: c.y is nan, not a real number". An
/// argument of one number has its letter alone; beyond the named axes of an argument or 26 arguments they are counted,
/// from 0: "coordinate 7 is nan".
[[noreturn]] void throw_non_finite(std::string_view formula, std::span<const int> arguments,
                                   std::span<const double> coordinates, std::string_view axes = "xyz",
                                   std::span<const std::string_view> names = {});

/// Throws as that where a coordinate is NaN or infinite, and only there.
template <Formula F>
void require_finite(const Coordinates<F>& p, std::string_view name = F::name) {
  double zero = 0;  // or NaN: one branch for all
  for (const double x : p) zero += x - x;
  if (!(zero == 0)) throw_non_finite(name, arguments<F>, p, axes<F>, argument_names<F>);
}

/// Has the library this formula's decisions, compiled once?  Those of the manifest it has.
template <class F>
inline constexpr bool in_library = false;
#define PLUMB_DECLARE(formula) \
  template <>                  \
  inline constexpr bool in_library<predicates::formula> = true;
PLUMB_PREDICATES(PLUMB_DECLARE)
#undef PLUMB_DECLARE

/// What is below, in a function of its own; for coordinates that the filter could not decide.
template <Formula F>
requires(!in_library<F>) [[gnu::noinline]] Decision decide_exactly(const Coordinates<F>& p);
// Defined where the catalog is compiled (src/certify/catalog_entry.hpp).  A declaration for each formula would cost
// every file that includes this one a millisecond.
template <Formula F>
requires in_library<F> Decision decide_exactly(const Coordinates<F>& p);

/// Of coordinates whose magnitudes are far apart, or at an end of the exponents: what no lattice of them holds.
template <Formula F>
[[gnu::noinline]] Decision decide_far(const Coordinates<F>& p) {
  const certify::Levels<F> levels(p);
  if (levels.are_low()) return decide_exactly<F>(certify::raised<F>(p));
  if (const auto s = repeated_argument_sign<F>(p, levels); s.certain()) return {s.value(), Stage::structural_zero};
  if (const auto s = long_double_sign<F>(p, levels); s.certain()) return {s.value(), Stage::long_double};
  if (const auto s = wide_integer_sign<F>(p, levels); s.certain()) return {s.value(), Stage::wide_integer};
  if (const auto s = interval_sign<F>(p); s.certain()) return {s.value(), Stage::interval};
  return {big_integer_sign(certify::tape::program<F>(), p), Stage::big_integer};
}

/// Exact stages in the order of their cost.
template <Formula F>
[[gnu::always_inline]] inline Decision decide_by_stages(const Coordinates<F>& p) {
  if constexpr (is_homogeneous<F>) {
    if (const auto s = integer_sign<F>(p); s.certain()) return {s.value(), Stage::integer};
  }
  require_finite<F>(p);
  if (const auto s = structural_zero_sign<F>(p); s.certain()) return {s.value(), Stage::structural_zero};
  if constexpr (has_wide_stages<F>) {
    const certify::Levels<F> levels(p);
    if (certify::begins_with_one_lattice<F>(levels, certify::integer::widest<F> - 53)) {
      if (const auto s = certify::integer::sign_on_lattice<F>(p); s.certain()) return {s.value(), Stage::wide_integer};
    }
    return decide_far<F>(p);
  } else {
    return {big_integer_sign(certify::tape::program<F>(), p), Stage::big_integer};
  }
}

template <Formula F>
requires(!in_library<F>) Decision decide_exactly(const Coordinates<F>& p) { return decide_by_stages<F>(p); }

/// decide below, whole, as the library has it (src/certify/compiled_signs.cpp).
template <Formula F>
requires in_library<F> Sign decide_in_library(const Coordinates<F>& p);

/// decide below, compiled where it stands.
template <Formula F, class Recorder>
constexpr Sign decide_here(const Coordinates<F>& p, Recorder&& recorder) {
  if (const int s = filter<F>(p); s != 0) [[likely]] {
    recorder.decided(Stage::filter);
    return static_cast<Sign>(s);
  }
  const Decision d = decide_exactly<F>(p);
  recorder.decided(d.stage);
  return d.sign;
}

// Functions for users that ask for one sign are templates (template <int = 0>): a compiler derives the filter of those
// that are called, and of no others.

// Code that is not optimized calls the library where that has the formula, and so is no slower than a call.  Its decide
// is a function of its own for the linker, as that which looks at the thread (checked.hpp); the answers are the same.
#if !defined(__OPTIMIZE__) && !defined(PLUMB_CHECKED)
#define PLUMB_CALLS_LIBRARY 1
#define PLUMB_DECIDES [[gnu::abi_tag("called")]]
#else
#define PLUMB_CALLS_LIBRARY 0
#define PLUMB_DECIDES PLUMB_CHECKABLE
#endif

/// The sign of F at p.  The recorder is told which stage decided.
template <Formula F, class Recorder = NoRecorder>
PLUMB_DECIDES constexpr Sign decide(const Coordinates<F>& p, Recorder&& recorder = {}) {
  static_assert(is_polynomial<F>());
  static_assert(use_all_coordinates<F>());
  assert_sound_thread();
  if constexpr (PLUMB_CALLS_LIBRARY && in_library<F> && std::is_same_v<Recorder, NoRecorder>) {
    if (!std::is_constant_evaluated()) return decide_in_library<F>(p);
  }
  return decide_here<F>(p, recorder);
}

/// What is no formula: the compiler says so in a sentence.
template <class F, class... Given>
requires(!Formula<F>) Sign decide(Given&&...) {
  static_assert(!std::is_same_v<F, F>,
                "plumb: a formula has a `name`, and `points` and `dimension` or `arguments` (predicates/orient.hpp); a "
                "lambda is asked by sign_of");
  return Sign::zero;
}

#undef PLUMB_CALLS_LIBRARY
#undef PLUMB_DECIDES

}  // namespace plumb
