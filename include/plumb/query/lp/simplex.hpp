// Linear programming, simplex method: which point of a system of any number of variables lies farthest along an
// objective?  In rational numbers.
//
//   LinearSystem s;
//   s.add({1, 2, 0, Rational(1, 3)}, 4);                 // x + 2 y + w / 3 <= 4
//   const LinearProof best = maximize(std::vector<Rational>{1, 1, 1, 1}, s);
//   best.kind; best.point; best.weights;
//
// Laws: exact, of any rows: zero ones, parallel, repeated and redundant ones, none.  Of several optimal points it is
// one that depends on the order of the rows.  verify(objective, system, best) is true.  As many variables as the
// objective has numbers; a row or a list of limits of another length throws InvalidShape, which names it.
// Source: Chvatal, Linear Programming, 1983, chapters 3, 5, 7; RTCD 9.4.
// Cost: some ten microseconds a pivot for few variables; of two and three query/lp/linear_program.hpp is faster by far.
// Bounded by the bases, of which n rows and d variables have n^d at most, n^4 operations for d = 3: no basis comes
// twice.
#pragma once

#include "plumb/query/lp/linear_proof.hpp"

namespace plumb {

LinearProof maximize(std::span<const Rational> objective, const LinearSystem& system);

}  // namespace plumb
