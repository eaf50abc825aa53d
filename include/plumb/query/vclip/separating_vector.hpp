// Chung-Wang separating vector: are two convex polyhedra disjoint?  A direction that parts them, turned after every
// failure.
//
//   SeparatingVector v = separating_vector(a, b);           // v.disjoint, v.direction
//   v = separating_vector(a, moved_b, {*v.direction});      // as a rule one look
//
// Of a direction the farthest corner of a and the least far one of b are found.  Where the one is not before the other,
// the direction is mirrored at the plane between them, which brings it nearer to every direction that parts the two.
// Laws: (1) `disjoint` is decided exactly, and is that of intersects.  (2) The direction, where one is told, parts the
// two strictly: every point of a lies less far along it than every one of b, in real arithmetic.  None is told of
// solids that meet, and of those that doubles do not part.  (3) It ends: where a pair of corners comes again, the exact
// search answers. (4) The start changes the time and the direction, never `disjoint`. Polyhedra, one or both under a
// pose.  One without faces throws InvalidShape, NaN and infinity NonFinite, by name.
// Source: RTCD 9.6; Chung and Wang, Quick collision detection of polytopes in virtual environments, 1996.
// Cost: a climb on each solid for every direction; docs/convex.md.  Bounded by n^2 signs for n corners of both, on
// integers as long as the exponents' span.
#pragma once

#include "plumb/query/vclip/vclip.hpp"

namespace plumb {

struct SeparatingVectorOptions {
  std::optional<Vector3> direction{};       // to begin with, as told before; else that between two corners
  std::array<std::uint32_t, 2> vertices{};  // from which the climbs begin, as told before
};

struct SeparatingVector {
  bool disjoint = false;
  std::optional<Vector3> direction{};
  std::array<std::uint32_t, 2> vertices{};  // the last: of a the farthest along it, of b the least far
  std::uint32_t steps = 0;
  bool by_search = false;
};

namespace query {

SeparatingVector separating_vector_of(const ClipView& a, const ClipView& b, const SeparatingVectorOptions& options);

}  // namespace query

template <query::ClipBody A, query::ClipBody B>
SeparatingVector separating_vector(const A& a, const B& b, const SeparatingVectorOptions& options = {}) {
  return query::separating_vector_of(query::clip_view(a), query::clip_view(b), options);
}

}  // namespace plumb
