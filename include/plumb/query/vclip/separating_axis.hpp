// Separating axis test (SAT): along which direction do two convex polyhedra lie one behind the other, apart or
// touching?
//
//   if (const auto axis = separating_axis(a, b)) ...   // axis->relation, axis->direction, and whose normal it is
//
// The faces of the difference of two solids are spanned by a face of one of them or by an edge of each.  So solids that
// do not overlap are parted along a face's normal, or along one that is at right angles to an edge of each.
// Laws: (1) nothing of solids that overlap.  (2) Else along `direction` no point of a lies farther than any of b; where
// the relation is disjoint, every point of a lies less far than every point of b, where it is touching there is no axis
// of which this holds. (3) It is the first such axis: of the faces of a, of those of b, of pairs of edges, in the order
// of the meshes. Polyhedra, one or both under a pose whose matrix is not singular.  A singular one and a polyhedron
// without faces throw InvalidShape, NaN and infinity NonFinite, by name.
// Source: RTCD 5.2.1, 9.2; Gottschalk 1996.
// Cost: a sign a face as a rule, then 10 operations for each pair of edges, of which few are left to signs.  Bounded by
// n^3 signs, on integers as long as the exponents' span: n^2 pairs of edges, and n vertices for each of those that no
// sign rules out.
#pragma once

#include <array>

#include "plumb/query/vclip/vclip.hpp"

namespace plumb {

enum class AxisKind : unsigned char { face_of_a, face_of_b, edges };

struct SeparatingAxis {
  Relation relation;
  AxisKind kind;
  std::uint32_t a = 0, b = 0;         // the face of the one that has it; the corners that the edges leave
  std::array<Rational, 3> direction;  // from a to b, of any length
};

namespace query {

std::optional<SeparatingAxis> separating_axis_of(const ClipView& a, const ClipView& b);

}  // namespace query

template <query::ClipBody A, query::ClipBody B>
std::optional<SeparatingAxis> separating_axis(const A& a, const B& b) {
  return query::separating_axis_of(query::clip_view(a), query::clip_view(b));
}

}  // namespace plumb
