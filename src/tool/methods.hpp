// How does each method take a decision?  One formula, run over the numbers that software commonly uses.
//
// Laws: every method gets the same doubles; float32 gets them rounded to floats beforehand, as software that stores
// floats does, and plan gets them as the kernel of the mesh's lattice keeps them.  An epsilon makes zeros of small
// values, as is commonly written; no decision of ours uses one. Source: RTCD 11.3.1 (tolerances), 11.2; cost: what
// check_mesh measures.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "plumb/certify/decide.hpp"
#include "plumb/certify/kernel.hpp"

namespace plumb::tool {

enum class Method : std::size_t { float32, double_plain, absolute, relative, long_double, interval, plan, exact };
inline constexpr std::size_t method_count = 8;

/// The epsilon that is on trial here.
inline constexpr double customary_epsilon = 1e-9;

template <Formula F, class Real>
using RealCoordinates = std::array<Real, arity<F>>;

template <Formula F, class Real>
RealCoordinates<F, Real> converted(const Coordinates<F>& p) {
  RealCoordinates<F, Real> r{};
  std::ranges::transform(p, r.begin(), [](double x) { return static_cast<Real>(x); });
  return r;
}

/// The points of a formula as a plan's kernel keeps them.
template <Formula F>
using PlannedPoints =
    std::array<LatticePoint<static_cast<std::size_t>(F::dimension)>, static_cast<std::size_t>(F::points)>;

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

/// What counts as zero in the size of the formula's terms: the largest difference to the last point, to the degree.
template <Formula F>
double size_of_terms(const Coordinates<F>& p) {
  constexpr auto axes = static_cast<std::size_t>(F::dimension);
  double largest = 0;
  for (std::size_t i = 0; i + axes < p.size(); ++i) {
    largest = std::max(largest, std::fabs(p[i] - p[p.size() - axes + i % axes]));
  }
  return power<degree<F>()>(largest);
}

/// The number that a method in floating point takes the sign of; 0 within an epsilon.
template <Formula F>
long double claimed_value(Method method, const Coordinates<F>& p) {
  const auto within = [](double value, double epsilon) { return std::fabs(value) <= epsilon ? 0 : value; };
  switch (method) {
    case Method::float32:
      return static_cast<long double>(F{}(converted<F, float>(p)));
    case Method::absolute:
      return within(F{}(p), customary_epsilon);
    case Method::relative:
      return within(F{}(p), customary_epsilon * size_of_terms<F>(p));
    case Method::long_double:
      return F{}(converted<F, long double>(p));
    default:
      return F{}(p);
  }
}

}  // namespace plumb::tool
