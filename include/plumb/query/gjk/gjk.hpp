// GJK, Gilbert, Johnson and Keerthi: do two convex bodies meet, where do they come closest, and by which simplices of their
// difference is that found?
//
//   gjk_intersects(a, b)                             yes or no
//   GjkCache cache;                                  kept by the caller from frame to frame
//   gjk_intersects(a, b, {.cache = &cache})          what proved the last answer is tried first
//   std::vector<GjkStep> history;
//   gjk(a, b, {.history = &history}).closest         every simplex on the way
//   gjk_distance(a, b)                               the number alone, which costs less
//   gjk(a, b, {.pair = WhichPair::first})            of several closest pairs the first one
//
// Bodies are those of query/separation/convex_body.hpp: hulls of corners, with a radius or without, as they stand or under
// a pose, in whose own frame the search climbs (9.5.6).
// Laws: (1) an answer is that of real arithmetic, and that of relate, distance and closest_points where these take the pair.
// Doubles search; what they find is proved, and where they do not tell or go round, exact numbers go on from the best
// simplex, each turn strictly nearer, so that it ends: no count of steps and no tolerance decides.  (2) A cache is a guess:
// whatever is in it, the answer is the same, but for the one of several closest pairs where any is asked for.  It may go with any two bodies.  (3) With a history the search is exact from
// its first simplex on: the corners of each are independent, their weights are above zero, and the squares fall strictly,
// before they are rounded.  (4) Of several closest pairs any one is told, and of bodies that meet any point that they have
// in common; with `WhichPair::first` that one which comes first in lexicographic order, as query/separation/separation.hpp
// says.  (5) Features are numbered as there; of a hull of points a feature is the least face that holds the exact point, by
// the lowest number of a given point that is in it.  Of any common point they are not told: both are the interior.
// NaN and infinity throw NonFinite, an empty body, a negative radius and a polygon that is not planar and convex InvalidShape,
// by name; UnevenPose as query/separation/posed.hpp says.  A polyhedron is one that convex_polyhedron made: gjk_intersects
// climbs on it, and does not look through its vertices.
// Source: Gilbert, Johnson and Keerthi 1988; RTCD 9.5, 9.5.1, 9.5.2, 9.5.4, 9.5.5, 9.5.6.
// Cost: docs/convex.md; no allocation where doubles decide.  The first pair of several takes a linear program in rationals,
// 0.1 to some milliseconds.  Bounded by n^2 signs for n corners of both, as a rule; ends whatever they are, for the
// distance falls with each simplex, so that none comes twice; on integers as long as the exponents' span.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/query/closest/result.hpp"
#include "plumb/query/closest/which_pair.hpp"
#include "plumb/query/separation/convex_body.hpp"

namespace plumb {

/// A corner of the difference: the numbers of a corner of a and of one of b.
using GjkCorner = std::array<std::uint32_t, 2>;

/// Up to four of them.
struct GjkSimplex {
  std::array<GjkCorner, 4> corners{};
  std::uint32_t size = 0;
  friend bool operator==(const GjkSimplex&, const GjkSimplex&) = default;
};

/// What proved the last answer.
struct GjkCache {
  GjkSimplex simplex;
  Vector3 direction{0, 0, 0};  // along which all of a is beyond all of b; zero where they meet
};

/// A simplex of a search, and the point of it that is nearest to the origin, each number rounded once.
struct GjkStep {
  GjkSimplex simplex;
  std::array<double, 4> weight{};  // of its corners, which add up to one
  Vector3 direction{0, 0, 0};      // from the origin to the point: the next corner is sought the other way
  double square = 0;               // of its distance
};

struct GjkOptions {
  GjkCache* cache = nullptr;
  std::vector<GjkStep>* history = nullptr;  // what is in it before is left there
  WhichPair pair = WhichPair::any;          // for gjk alone
};

struct GjkAnswer {
  bool meets;
  Closest closest;
  std::uint32_t steps;  // simplices looked at, the last one included
  GjkSimplex simplex;   // the corners between whose hulls the distance is; four, where they are around the origin
};

namespace query {

bool gjk_meets(const BodyView& a, const BodyView& b, const GjkOptions& options);
double gjk_apart_by(const BodyView& a, const BodyView& b, const GjkOptions& options);
GjkAnswer gjk_answer(const BodyView& a, const BodyView& b, const GjkOptions& options);

}  // namespace query

template <ConvexBody3 A, ConvexBody3 B>
bool gjk_intersects(const A& a, const B& b, const GjkOptions& options = {}) {
  return query::gjk_meets(query::body_view(a), query::body_view(b), options);
}

template <ConvexBody3 A, ConvexBody3 B>
GjkAnswer gjk(const A& a, const B& b, const GjkOptions& options = {}) {
  return query::gjk_answer(query::body_view(a), query::body_view(b), options);
}

template <ConvexBody3 A, ConvexBody3 B>
double gjk_distance(const A& a, const B& b, const GjkOptions& options = {}) {
  return query::gjk_apart_by(query::body_view(a), query::body_view(b), options);
}

}  // namespace plumb
