// Penetration depth: what is the least translation that parts two convex bodies, and which of their features touch
// after it?
//
//   penetration(a, b)          if (const auto p = penetration(box, hull)) { p->depth; p->direction; p->feature_a; }
//   exact_penetration(a, b)    the same without any rounding
//   penetration(a, b, &cache)  the same again, from frame to frame: of bodies that did not move it takes a look, and of
//                              polyhedra that did it takes less
//
// Two bodies are parted where a plane has one of them on each side; both may touch it, and each other.  So solids are
// parted where their interiors do not meet, and what is left of them is touching; the depth of a triangle that crosses
// another, or is within a solid, is above zero, for no plane has them on different sides; and flat bodies in one plane
// are parted as they are: their depth is zero, along the plane's normal.
// Laws: (1) `depth` is the least length of a translation of the first body after which the two are parted, `direction`
// its direction, the first one moving: exact, then rounded once.  (2) Bodies that are disjoint have none: ask distance
// or closest_points (query/separation/separation.hpp).  Bodies that touch have depth zero, and the direction of a plane
// between them.  (3) Where several directions are as short, `is_unique` is false, and of the facets of the Minkowski
// difference that are nearest that one is told whose unit direction comes first in lexicographic order; of bodies whose
// difference is flat, of the directions at right angles to it.  (4) The features are what of each body lies in the
// plane between them after the translation: the vertex, the edge or the face of the lowest number that is of the
// dimension of what lies there, and wholly in the plane.  They are numbered as elsewhere
// (query/separation/convex_body.hpp); of a hull by its vertices alone the edge or face has the number of its lowest
// vertex.  (5) Where the direction is unique, penetration(b, a) is the same with the opposite direction; a translation
// of both changes nothing.  (6) Round bodies are their cores and a radius: while the cores overlap, the depth is that
// of the cores and both radii, else the radii less the distance of the cores. NaN and infinity throw NonFinite, an
// empty body, a negative radius and a polygon that is not planar and convex InvalidShape, a pose that makes no ball of
// a ball UnevenPose, by name.  (7) A cache, which contact() takes as well, changes no bit
// of an answer, whatever it was used for before.
// Source: RTCD 9.3.8, 9.5; van den Bergen 2001 (EPA).
// Cost: docs/measurements.md; the exact answer some microseconds more.  Bounded by n^2 log n signs for n corners of
// both, on integers as long as the exponents' span: their difference has n^2 vertices at most.
#pragma once

#include <optional>
#include <vector>

#include "plumb/arith/exact_vector.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"
#include "plumb/query/separation/convex_body.hpp"

namespace plumb {

/// Of the first body; of two that are named the other way round it is that of the other.
struct Penetration {
  double depth;
  Vector3 direction;    // of length 1, but for rounding
  Vector3 translation;  // so far along the direction
  Feature feature_a, feature_b;
  bool is_unique;
  friend bool operator==(const Penetration&, const Penetration&) = default;
};

namespace query {
struct KeptBytes;
}  // namespace query

/// The last question, bit by bit, and its answer.
class KeptAnswer {
  friend query::KeptBytes;
  std::vector<unsigned char> bytes_;
};

/// What the last answer for a pair of bodies was found by, and that answer.
struct ContactCache {
  std::array<std::array<std::uint32_t, 2>, 4> corners{};  // of the difference
  std::uint32_t size = 0;
  std::array<std::array<std::uint32_t, 2>, 2> edges{};  // of boxes: the body and its edge, where a plane is along both
  bool has_edges = false;
  KeptAnswer last;
};

struct ExactPenetration {
  ExactVector3 direction;  // integers without a common factor
  ExactVector3
      core_translation;  // parts the cores, or makes them touch where they are apart; of what is not round: all of it
  Rational core_square;  // the square of its length
  bool cores_are_apart;  // then the depth is `radii` less that length, else it is their sum
  Rational radii;        // both together; zero where neither body is round
  Feature feature_a, feature_b;
  bool is_unique;
};

namespace query {

std::optional<Penetration> penetration_of(const BodyView& a, const BodyView& b, ContactCache* cache = nullptr);
/// The same of figures whose kinds are known at run time alone; a recorder keeps it (query/variant/question_recorder.hpp).
std::optional<Penetration> any_penetration_of(const BodyView& a, const BodyView& b, ContactCache* cache);
std::optional<ExactPenetration> exact_penetration_of(const BodyView& a, const BodyView& b);

}  // namespace query

template <ConvexBody3 A, ConvexBody3 B>
std::optional<Penetration> penetration(const A& a, const B& b, ContactCache* cache = nullptr) {
  if constexpr (std::same_as<A, AnyFigure> || std::same_as<B, AnyFigure>) {
    return query::any_penetration_of(query::body_view(a), query::body_view(b), cache);
  } else {
    return query::penetration_of(query::body_view(a), query::body_view(b), cache);
  }
}

template <ConvexBody3 A, ConvexBody3 B>
std::optional<ExactPenetration> exact_penetration(const A& a, const B& b) {
  return query::exact_penetration_of(query::body_view(a), query::body_view(b));
}

}  // namespace plumb
