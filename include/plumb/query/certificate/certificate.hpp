// Certificate: how do two convex bodies lie, and which few numbers prove it?  Separating axes, touching planes,
// simplices of the Minkowski difference, and nearest points, to be checked without the search that found them.
//
//   const Certificate proof = relate_with_proof(box, Posed{hull, pose});
//   proof.claim                               what relate says
//   verify(proof, box, Posed{hull, pose})     by sums and products alone (query/certificate/verify.hpp)
//
// A body is the hull of its vertices and all within its radius of that (query/separation/convex_body.hpp); R is both
// radii together.  A certificate has a direction, or pairs, or both:
//   direction n   gap: the least n.v of vertices v of b, less the greatest n.u of vertices u of a
//   pairs         a vertex u of a and a vertex v of b each, with weights above zero of sum 1;
//                 d: the sum of weight (u - v)
// What they prove:
//   disjoint      gap > 0 and gap^2 > R^2 n.n
//   touching      |d|^2 = R^2 and gap^2 = R^2 n.n, with gap >= 0 and n not zero; where R is 0, some vertex is off the
//                 plane that the gap is
//   overlapping   |d|^2 < R^2; or R and d are 0, and the differences u - v of the pairs span every way from one vertex
//                 to another, of a or of b
//   intersecting  |d|^2 <= R^2
//   a distance    |d|^2 is its square; gap^2 = |d|^2 n.n with gap > 0, or d is 0
// docs/convex.md says why.
// Laws: (1) the claim of relate_with_proof is relate's, that of intersects_with_proof disjoint where intersects says
// no, else intersecting; the distance is that of exact_distance.  Of hulls and under poses likewise, exactly.  (2)
// Every certificate given here is verified by `verify`.  (3) An overlapping one has thirteen pairs at most, in general
// position four; others four.  (4) A direction is of doubles where doubles prove it, else of integers without a common
// factor.
// NaN and infinity throw NonFinite; an empty body, a negative radius, a polygon that is not convex and a
// polyhedron with a flaw (figure/basic/polyhedron.hpp) InvalidShape, by name; a round body whose pose makes an
// ellipsoid of it UnevenPose.
// Source: Rockafellar, Convex Analysis, 1970, theorems 6.4, 6.6 and 11.3; Mehlhorn et al., Checking geometric programs,
// 1999; RTCD 5.2.1, 9.1.
// Cost: integers and rationals of any size: some 30 us for bodies of 8 vertices, 40 for hulls of 128; where they touch
// without radii some 50 us, and 5 us a vertex; of a polyhedron its check, 1 us a vertex.  Bounded by n^2 signs for n
// corners of both, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "plumb/arith/exact_distance.hpp"
#include "plumb/arith/exact_vector.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/query/separation/convex_body.hpp"

namespace plumb {

enum class Claim : signed char { disjoint = -1, touching = 0, overlapping = 1, intersecting = 2 };

constexpr Claim claim_of(Relation r) { return static_cast<Claim>(r); }
constexpr std::string_view name_of(Claim c) {
  return c == Claim::disjoint      ? "disjoint"
         : c == Claim::touching    ? "touching"
         : c == Claim::overlapping ? "overlapping"
                                   : "intersecting";
}

/// A vertex of a and one of b, by their numbers.
struct WeightedPair {
  std::uint32_t of_a, of_b;
  Rational weight;
  friend bool operator==(const WeightedPair&, const WeightedPair&) = default;
};

struct Certificate {
  Claim claim = Claim::disjoint;
  std::optional<ExactVector3> direction;  // of what is disjoint or touches
  std::vector<WeightedPair> pairs;        // of what meets
  friend bool operator==(const Certificate&, const Certificate&) = default;
};

/// The points of the cores that the pairs are, each the sum of its vertices by the weights, are nearest to one another.
struct DistanceCertificate {
  double distance = 0;                    // rounded once
  ExactDistance exact;                    // the square is that of the cores, the inset both radii together
  std::optional<ExactVector3> direction;  // where the cores do not meet
  std::vector<WeightedPair> pairs;
};

namespace query {

Certificate certified_relation(const BodyView& a, const BodyView& b);
Certificate certified_intersection(const BodyView& a, const BodyView& b);
DistanceCertificate certified_distance(const BodyView& a, const BodyView& b);

}  // namespace query

template <ConvexBody3 A, ConvexBody3 B>
Certificate relate_with_proof(const A& a, const B& b) {
  return query::certified_relation(query::body_view(a), query::body_view(b));
}

template <ConvexBody3 A, ConvexBody3 B>
Certificate intersects_with_proof(const A& a, const B& b) {
  return query::certified_intersection(query::body_view(a), query::body_view(b));
}

template <ConvexBody3 A, ConvexBody3 B>
DistanceCertificate distance_with_proof(const A& a, const B& b) {
  return query::certified_distance(query::body_view(a), query::body_view(b));
}

}  // namespace plumb
