// Linear programming: which point of a polyhedron lies farthest, exactly?  Linear programs of few variables in
// rationals.
//
// Laws: the optimum is exact; every program ends, for after some pivots the smallest index is taken (Bland).  Of an
// infeasible program those that decide have weights with which their rows add up to zero and their limits to less
// (Farkas).
// Method: the simplex method on the dual program, whose basis has one row for each variable; its multipliers are the
// point.  Integers over one determinant, of which a pivot divides the last one away.
// Source: Chvatal, Linear Programming, 1983, chapters 3, 5, 7; RTCD 9.4; Edmonds 1967, Bareiss 1968 (elimination without
// fractions).
// Cost: a pivot some products of integers for each constraint and variable.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <span>
#include <vector>

namespace plumb::arith {

using RationalVector = std::vector<mpq_class>;

mpq_class dot(const RationalVector& a, const RationalVector& b);

/// All x with rows[i] . x <= limits[i].
struct Constraints {
  std::vector<RationalVector> rows;
  RationalVector limits;

  void add(RationalVector row, mpq_class limit) {
    rows.push_back(std::move(row));
    limits.push_back(std::move(limit));
  }
};

struct Optimum {
  enum class Kind : unsigned char { optimal, unbounded, infeasible };  // unbounded: or infeasible
  Kind kind;
  RationalVector at;                  // an optimal point
  std::vector<std::size_t> deciding;  // constraints of positive weight: met with equality by every optimal point
  RationalVector weights = {};        // of those that decide: their rows add up to the objective
  RationalVector ray = {};            // of an unbounded program: no row grows along it, but the objective does
};

/// The greatest objective . x.
Optimum maximize(const RationalVector& objective, const Constraints& constraints);

/// Of y >= 0 with sum y_j rows_j = objective: each of limits . y as small as those before it leave it.  Nothing where
/// there is no such y, or one of them has no least value.
std::optional<RationalVector> least_in_turn(const RationalVector& objective, const std::vector<RationalVector>& rows,
                                            std::span<const RationalVector> limits);

/// A point that meets the constraints, those of `strictly` with slack where some point does.
struct Feasible {
  int slack;  // -1: no point meets them; 0: none meets all of `strictly` with slack; 1: `at` does
  RationalVector at;
  std::vector<std::size_t> deciding;  // for slack 0: of those, some that no point meets with slack
};
Feasible feasible(const Constraints& constraints, const std::vector<bool>& strictly);

}  // namespace plumb::arith
