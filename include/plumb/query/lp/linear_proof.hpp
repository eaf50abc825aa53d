// Linear programming, Farkas certificate: what does the answer to a linear program rest on?  Exact numbers that anybody
// can check in a few multiplications.
//
//   program:  maximize  objective . x  where  rows[i] . x <= limits[i]
//   optimal: `point` meets all rows, and `weights` at least zero of rows that it meets with equality add up to the
//            objective.  For any x that meets the rows, objective . x = sum weight (row . x) <= sum weight limit =
//            objective . point.
//   infeasible: `weights` at least zero, under which the rows add up to zero and the limits to less than zero: whoever
//            met the rows would have 0 <= a negative number (Farkas).
//   unbounded: `point` meets all rows, and along `ray` no row grows, but the objective does.
//
// Laws: exact; of infeasible rows at most one more than there are variables have a weight, of an optimum at most as
// many as there are variables.  verify (query/lp/verify.hpp) says whether a proof is one, whoever made it.
// Source: Chvatal, Linear Programming, 1983, chapters 5 and 9; RTCD 9.4.
// Cost: an allocation a number.  Nothing is searched.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "plumb/arith/rational.hpp"
#include "plumb/figure/basic/plane.hpp"

namespace plumb {

enum class LinearKind : unsigned char { optimal, infeasible, unbounded };

constexpr std::string_view to_string(LinearKind k) {
  return k == LinearKind::optimal ? "optimal" : k == LinearKind::infeasible ? "infeasible" : "unbounded";
}

/// All x with rows[i] . x <= limits[i].
struct LinearSystem {
  std::vector<std::vector<Rational>> rows;
  std::vector<Rational> limits;

  void add(std::vector<Rational> row, Rational limit) {
    rows.push_back(std::move(row));
    limits.push_back(std::move(limit));
  }
  friend bool operator==(const LinearSystem&, const LinearSystem&) = default;
};

/// The same of halfspaces, in their order; NaN and infinity throw NonFinite, by name.
LinearSystem linear_system(std::span<const Halfspace2> halfspaces);
LinearSystem linear_system(std::span<const Halfspace3> halfspaces);

/// How often a constraint counts in a sum; constraints that are not named count zero times.
struct LinearWeight {
  std::size_t constraint;
  Rational weight;
  friend bool operator==(const LinearWeight&, const LinearWeight&) = default;
};

struct LinearProof {
  LinearKind kind = LinearKind::optimal;
  std::vector<Rational> point;        // of optimal and unbounded programs
  std::vector<LinearWeight> weights;  // of optimal and infeasible ones
  std::vector<Rational> ray;          // of unbounded ones
  friend bool operator==(const LinearProof&, const LinearProof&) = default;
};

}  // namespace plumb
