// What all files on k-DOPs share: their checks, and their halfspaces in rationals.
//
// Source: RTCD 4.6.
// Cost: checks one comparison a number.
#pragma once

#include <string>
#include <string_view>

#include "arith/rational_lp.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"

namespace plumb::figure {

/// Of two that are compared.
template <class Vector>
void check(std::string_view function, const KDop<Vector>& a, const KDop<Vector>& b) {
  require_sound(function, "a", a);
  require_sound(function, "b", b);
  if (!(a.directions == b.directions))
    throw InvalidShape(std::string(function).append(": a and b have different directions; fit both with the same"));
}

template <class Vector>
bool has_empty_interval(const KDop<Vector>& k_dop) {
  for (std::size_t i = 0; i < k_dop.min.size(); ++i) {
    if (k_dop.min[i] > k_dop.max[i]) return true;
  }
  return false;
}

template <class Vector>
arith::RationalVector rational(const Vector& v) {
  const auto numbers = coordinates(v);
  return {numbers.begin(), numbers.end()};
}

/// Halfspace 2 i is directions[i] . x <= max[i], halfspace 2 i + 1 is -directions[i] . x <= -min[i].
template <class Vector>
arith::Constraints halfspaces(const KDop<Vector>& k_dop) {
  arith::Constraints all;
  for (std::size_t i = 0; i < k_dop.directions.size(); ++i) {
    arith::RationalVector normal = rational(k_dop.directions.all()[i]);
    all.add(normal, k_dop.max[i]);
    for (mpq_class& x : normal) x = -x;
    all.add(std::move(normal), -k_dop.min[i]);
  }
  return all;
}

inline bool is_empty(const arith::Constraints& halfspaces) {
  return arith::feasible(halfspaces, std::vector<bool>(halfspaces.rows.size(), true)).slack < 0;
}

}  // namespace plumb::figure
