// What all files on k-DOPs share: their checks, and their halfspaces in rationals.
//
// Source: RTCD 4.6.
// Cost: checks one comparison a number.
#pragma once

#include <string>
#include <string_view>

#include "arith/rational_lp.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"

namespace plumb::figure {

/// Throws InvalidShape for ends of the wrong number, NonFinite for one that is no real number.
template <class Vector>
void check(std::string_view function, std::string_view name, const KDop<Vector>& k_dop) {
  const std::size_t n = k_dop.directions.size();
  if (k_dop.min.size() != n || k_dop.max.size() != n) {
    throw InvalidShape(std::string(function)
                           .append(": ")
                           .append(name)
                           .append(" has ")
                           .append(std::to_string(k_dop.min.size()))
                           .append(" entries in min and ")
                           .append(std::to_string(k_dop.max.size()))
                           .append(" in max for ")
                           .append(std::to_string(n))
                           .append(" directions; give one for each"));
  }
  double zero = 0;
  for (std::size_t i = 0; i < n; ++i) zero += (k_dop.min[i] - k_dop.min[i]) + (k_dop.max[i] - k_dop.max[i]);
  if (zero == 0) return;
  for (const auto& [part, numbers] : {std::pair{".min[", &k_dop.min}, std::pair{".max[", &k_dop.max}}) {
    for (std::size_t i = 0; i < n; ++i) {
      if ((*numbers)[i] - (*numbers)[i] == 0) continue;
      const std::string which = std::string(name).append(part).append(std::to_string(i)).append("]");
      const std::array<std::string_view, 1> names{which};
      throw_non_finite(function, std::array{1}, std::array{(*numbers)[i]}, "xyz", names);
    }
  }
}

/// Of two that are compared.
template <class Vector>
void check(std::string_view function, const KDop<Vector>& a, const KDop<Vector>& b) {
  check(function, "a", a);
  check(function, "b", b);
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
