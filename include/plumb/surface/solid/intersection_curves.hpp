// Intersection curves: where do two surfaces meet, exactly?  Polylines, closed or open, and points where they touch.
//
//   for (const IntersectionCurve& c : intersection_curves(a, b)) use(c.points, c.closed, c.faces);
//
// Both may be open, closed, or cross themselves; vertices at one point are one.
// Laws: (1) what the curves cover is what the surfaces have in common: of areas that lie in faces of both, their boundaries
// alone.  (2) A curve ends where more or fewer than two of its edges meet, and two curves have nothing but such ends in
// common; a closed one has no end, or begins and ends at one.  (3) A point where nothing else is in common is a curve of
// one point.  (4) Each edge lies in one face of a, and in one of b; the least that hold it are told, and of a curve of one
// point the least that hold that.  (5) A closed curve begins at its least point, unless it begins at an end, and goes on
// to the lesser neighbor; an open one begins at its lesser end.  Curves are in the order of their points: so they do not
// depend on the order of vertices and triangles, nor on threads.
// A triangle that names no vertex throws InvalidShape, NaN and infinity throw NonFinite.
// Source: RTCD 2.2.1.
// Cost: that of two trees and intersecting_pairs, and of arrange for the triangles that meet.  Bounded by n^4 signs.
#pragma once

#include <array>
#include <vector>

#include "plumb/certify/exact_point.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb {

struct IntersectionCurve {
  std::vector<ExactPoint3> points;  // of a closed one the first is not told again
  bool closed = false;
  /// A triangle of a and one of b for each edge: from points[i] to the next.
  std::vector<std::array<std::uint32_t, 2>> faces;
};

std::vector<IntersectionCurve> intersection_curves(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace plumb
