// Quadratic programming: which point of an intersection of halfspaces is nearest to a point?  Exactly, with its
// multipliers.
//
//   const NearestFeasible3 n = nearest_feasible(p, halfspaces);
//   n.at, n.distance;                                             // the nearest doubles
//   verify_nearest(std::vector<Rational>{p.x, p.y, p.z}, linear_system(halfspaces), n.proof)
//
// Seidel's algorithm: the nearest point so far stays, or the next constraint decides, and the nearest point lies in its
// plane.
// Laws: (1) exact, of zero normals, parallel, repeated and redundant constraints, and of any exponents.  The point is
// unique, and depends on no order.  (2) The proof is that of Karush, Kuhn and Tucker: normals of constraints that the
// point meets with equality, with weights above zero, at most as many as there are dimensions, add up to the way from
// it to p.
// (3) Where no point meets all constraints the kind is infeasible, and the proof is that of the linear program.
// NaN and infinity throw NonFinite, by name.
// Source: Karush 1939; Kuhn and Tucker 1951; Seidel 1991; RTCD 9.4.2.
// Cost: expected linear in the constraints, some 100 ns a constraint and a few microseconds for each that moves the
// point.  Bounded by n expected signs for each variable, on integers as long as the exponents' span; at worst n^3.
#pragma once

#include "plumb/arith/exact_distance.hpp"
#include "plumb/query/lp/linear_proof.hpp"

namespace plumb {

struct NearestFeasible2 {
  LinearKind kind = LinearKind::optimal;  // or infeasible
  Point2 at{};
  double distance = 0;
  ExactDistance exact_distance;
  LinearProof proof;
};
struct NearestFeasible3 {
  LinearKind kind = LinearKind::optimal;
  Point3 at{};
  double distance = 0;
  ExactDistance exact_distance;
  LinearProof proof;
};

NearestFeasible2 nearest_feasible(const Point2& p, std::span<const Halfspace2> constraints);
NearestFeasible3 nearest_feasible(const Point3& p, std::span<const Halfspace3> constraints);

}  // namespace plumb
