// Linear programming, certificate checking: is this proof one?  No solver is asked: a few sums of exact numbers.
//
//   verify(objective, system, maximize(objective, system))           // true, of any system
//   verify(direction, halfspaces, proof_of(maximize(direction, halfspaces)))
//
// Laws: true exactly where the proof shows what its kind says (query/lp/linear_proof.hpp), and false of any other, one
// with too few numbers or with a constraint that there is none of included.  A proof of `optimal` of the objective zero
// shows that its point is feasible.
// Source: Karush 1939, and Kuhn and Tucker 1951, for the nearest point; RTCD 9.4.
// Cost: a product for each number of the system.  Nothing is searched.
#pragma once

#include "plumb/query/lp/greatest_margin.hpp"
#include "plumb/query/lp/linear_proof.hpp"

namespace plumb {

bool verify(std::span<const Rational> objective, const LinearSystem& system, const LinearProof& proof);

bool verify(const Vector2& objective, std::span<const Halfspace2> halfspaces, const LinearProof& proof);
bool verify(const Vector3& objective, std::span<const Halfspace3> halfspaces, const LinearProof& proof);

/// Is proof.point the point of the system that is nearest to `from`?  It is where it meets all rows, and weights at
/// least zero of rows that it meets with equality add up to from - point.  Of kind infeasible it is as above.
bool verify_nearest(std::span<const Rational> from, const LinearSystem& system, const LinearProof& proof);

/// Does the margin part the sets, and is it the greatest?  It is where the supporting points, with weights at least
/// zero that add up to one, are two points whose difference is the direction, and no point of either set lies before
/// its own in that direction: then any slab between the sets also lies between these two points.
bool verify(std::span<const Point3> first, std::span<const Point3> second, const GreatestMargin3& margin);

}  // namespace plumb
