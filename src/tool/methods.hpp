// How does each method take a decision?  One formula, run over the numbers that software commonly uses.
//
// Laws: those of tool/trial/formula_numbers.hpp.  Source: RTCD 11.3.1 (tolerances), 11.2; cost: what check_mesh
// measures.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "tool/trial/formula_numbers.hpp"

namespace plumb::tool {

enum class Method : std::size_t { float32, double_plain, absolute, relative, long_double, interval, plan, exact };
inline constexpr std::size_t method_count = 8;

using trial::converted;
using trial::customary_epsilon;
using trial::PlannedPoints;
using trial::size_of_terms;
using trial::taken_in;

/// The coordinates of a formula in another kind of number.
template <Formula F, class Real>
using RealCoordinates = std::array<Real, arity<F>>;

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
