// Does plain floating point prove the sign?  The two derived filters.
//
// Laws: a certain answer is the sign of the exact value, for any doubles at all (NaN, infinity, overflow and underflow
// end as unsure); zero is never certain here.  The answer is formed without a branch on the sign: signs are
// unpredictable. Source: RTCD 11.2, docs/proof.md; cost: 1.2 to 2 times the plain formula.
#pragma once

#include <algorithm>

#include "plumb/arith/filtered.hpp"
#include "plumb/arith/largest.hpp"
#include "plumb/certify/formula.hpp"

namespace plumb {

/// -1, 0 or 1, where 0 is 'unsure': the form in which the hot path uses a filter.
template <class Value> constexpr int beyond(Value value, Value threshold) {
  return static_cast<int>(value > threshold) - static_cast<int>(value < -threshold);
}

/// Filter A: against the sum of the absolute products.
template <Formula F> constexpr int magnitude_filter(const Coordinates<F>& p) {
  std::array<Filtered::Input, arity<F>> in{};
  for (std::size_t i = 0; i < in.size(); ++i) in[i] = {p[i]};
  const Filtered r = F{}(in);
  return beyond(r.value, filter_constant<F>() * r.magnitude);
}

/// The threshold of filter B for differences up to these bounds, one for each axis.
template <Formula F>
constexpr double largest_threshold(const std::array<double, static_cast<std::size_t>(F::dimension)>& largest) {
  std::array<LargestMagnitude::Input, arity<F>> in{};
  for (std::size_t i = 0; i < in.size(); ++i) in[i] = {largest[i % largest.size()]};
  return filter_constant<F>() * F{}(in).magnitude;
}

/// Filter B: against the magnitude that the largest differences allow.
template <Formula F> constexpr int largest_filter(const Coordinates<F>& p) {
  std::array<double, static_cast<std::size_t>(F::dimension)> largest{};
  std::array<Watched::Input, arity<F>> in{};
  for (std::size_t i = 0; i < in.size(); ++i) in[i] = {p[i], &largest[i % largest.size()]};
  const Watched r = F{}(in);
  return beyond(r.value, largest_threshold<F>(largest));
}

}  // namespace plumb
