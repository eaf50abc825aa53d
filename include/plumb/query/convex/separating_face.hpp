// Approximate hull tests: does a face of one convex polyhedron part it from another?  Cheap, exact in what it says, and
// silent on the rest.
//
//   if (separating_face(a, b)) ...      // they are disjoint; without one they may still be
//
// Laws: (1) where a face is told, all of the other polyhedron is strictly outside of its plane, and relate says disjoint.
// (2) Polyhedra that meet are never parted.  Where only the directions of edges part them, no face is told.  (3) The face is
// the lowest of the first polyhedron, else the lowest of the second.
// A face whose corners are on one line parts nothing.  Numbers must be finite: NaN and infinity throw NonFinite.
// Source: RTCD 4.6.5.
// Cost: a sign for each vertex of the other that lies outside of a face, at most faces times vertices; of the face told
// last time, which comes first where it is given, the vertices alone.  Bounded by n^2 signs, on integers as long as the
// exponents' span.
#pragma once

#include <cstdint>
#include <optional>

#include "plumb/figure/basic/convex_polyhedron.hpp"

namespace plumb {

struct SeparatingFace {
  bool of_second;
  std::uint32_t face;
  friend bool operator==(const SeparatingFace&, const SeparatingFace&) = default;
};

std::optional<SeparatingFace> separating_face(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b);
/// First by this face, which parted the two before they moved.
std::optional<SeparatingFace> separating_face(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b,
                                              const SeparatingFace& last);

}  // namespace plumb
