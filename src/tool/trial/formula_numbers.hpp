// In which numbers does a method take a formula?  What `plumb check` and `plumb chart` have in common.
//
// Laws: every method gets the same doubles; float32 gets them rounded to floats beforehand, as software that stores
// floats does, and plan as the kernel of the scene's lattice keeps them.  An epsilon makes zeros of small values, as is
// commonly written; no decision of ours uses one.
// Source: RTCD 11.2, 11.3.1 (tolerances); cost: what is measured.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "plumb/certify/decide.hpp"
#include "plumb/certify/kernel.hpp"

namespace plumb::tool::trial {

/// The epsilon that is on trial here.
inline constexpr double customary_epsilon = 1e-9;

/// What counts as zero in the size of the formula's terms: the largest difference to the last point, to the degree.
template <Formula F>
double size_of_terms(const Coordinates<F>& p) {
  constexpr auto dimension = static_cast<std::size_t>(F::dimension);
  double largest = 0;
  for (std::size_t i = 0; i + dimension < p.size(); ++i) {
    largest = std::max(largest, std::fabs(p[i] - p[p.size() - dimension + i % dimension]));
  }
  return power<degree<F>()>(largest);
}

/// The formula over another kind of floating-point number, which takes every double's value or rounds it.
template <Formula F, class Real>
std::array<Real, arity<F>> converted(const Coordinates<F>& p) {
  std::array<Real, arity<F>> r{};
  std::ranges::transform(p, r.begin(), [](double x) { return static_cast<Real>(x); });
  return r;
}

/// The points of a formula as a plan's kernel keeps them.
template <Formula F>
using PlannedPoints =
    std::array<LatticePoint<static_cast<std::size_t>(F::dimension)>, static_cast<std::size_t>(F::points)>;

/// Takes them in, checked.
template <Formula F>
PlannedPoints<F> taken_in(const Kernel& kernel, const Coordinates<F>& p) {
  PlannedPoints<F> taken;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    std::array<double, static_cast<std::size_t>(F::dimension)> x{};
    std::copy_n(p.begin() + static_cast<std::ptrdiff_t>(i * x.size()), x.size(), x.begin());
    taken[i] = kernel.point(x);
  }
  return taken;
}

}  // namespace plumb::tool::trial
