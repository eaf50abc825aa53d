// Adaptive precision: what is the sign of a formula at these coordinates, exactly?  The chain of stages.
//
// Laws: the answer is the sign of the exact value for all finite doubles; anything else throws NonFinite, naming the
// argument.  The order of the stages changes the time, never the answer.
// Source: docs/proof.md; the order and what is left out: docs/measurements.md, "Stages".
// Cost: the filter where it is sure; then as exact_stages.hpp says.
#pragma once

#include <algorithm>
#include <type_traits>

#include "plumb/certify/accepted.hpp"
#include "plumb/certify/checked.hpp"
#include "plumb/certify/decision.hpp"
#include "plumb/certify/environment.hpp"
#include "plumb/certify/exact_stages.hpp"
#include "plumb/certify/filter_stage.hpp"
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
  if (!std::ranges::all_of(p, [](double x) { return x - x == 0; }))
    throw_non_finite(name, arguments<F>, p, axes<F>, argument_names<F>);
}

/// Does it pay to compile the wide integers and the interval for this formula?  For those that are asked most, by
/// measurement (docs/measurements.md, "Stages"); the last stage serves the others without code of their own.
template <Formula F>
inline constexpr bool has_wide_stages = false;
template <>
inline constexpr bool has_wide_stages<predicates::Orient2d> = true;
template <>
inline constexpr bool has_wide_stages<predicates::Orient3d> = true;
template <>
inline constexpr bool has_wide_stages<predicates::InCircle> = true;
template <>
inline constexpr bool has_wide_stages<predicates::InSphere> = true;

/// Exact stages in the order of their cost; for coordinates that the filter could not decide.
template <Formula F>
[[gnu::noinline]] Decision decide_exactly(const Coordinates<F>& p) {
  if constexpr (is_homogeneous<F>) {
    if (const auto s = integer_sign<F>(p); s.certain()) return {s.value(), Stage::integer};
  }
  require_finite<F>(p);
  if (const auto s = structural_zero_sign<F>(p); s.certain()) return {s.value(), Stage::structural_zero};
  if constexpr (is_homogeneous<F> && has_wide_stages<F>) {
    if (const auto s = wide_integer_sign<F>(p); s.certain()) return {s.value(), Stage::wide_integer};
  }
  if constexpr (has_wide_stages<F>) {
    if (const auto s = interval_sign<F>(p); s.certain()) return {s.value(), Stage::interval};
  }
  return {big_integer_sign(tape::program<F>(), p), Stage::big_integer};
}

/// The sign of F at p.  The recorder is told which stage decided.
template <Formula F, class Recorder = NoRecorder>
PLUMB_CHECKABLE constexpr Sign decide(const Coordinates<F>& p, Recorder&& recorder = {}) {
  static_assert(is_polynomial<F>());
  static_assert(use_all_coordinates<F>());
  assert_sound_thread();
  if (const int s = filter<F>(p); s != 0) [[likely]] {
    recorder.decided(Stage::filter);
    return static_cast<Sign>(s);
  }
  const Decision d = decide_exactly<F>(p);
  recorder.decided(d.stage);
  return d.sign;
}

// The exact stages of the manifest's formulas are compiled once, into the library.
#define PLUMB_DECLARE(formula) \
  extern template Decision decide_exactly<predicates::formula>(const Coordinates<predicates::formula>&);
PLUMB_PREDICATES(PLUMB_DECLARE)
#undef PLUMB_DECLARE

// Whole decisions as well: code that is not optimized calls them, optimized code may inline them all the same.
#ifndef PLUMB_CHECKED
#define PLUMB_DECLARE(formula) \
  extern template Sign decide<predicates::formula>(const Coordinates<predicates::formula>&, NoRecorder&&);
PLUMB_PREDICATES(PLUMB_DECLARE)
#undef PLUMB_DECLARE
#endif

}  // namespace plumb
