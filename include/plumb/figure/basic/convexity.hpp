// Is it convex?  Quadrilaterals, polygons and the surfaces of polyhedra, degenerate ones told apart.
//
// Laws: (1) a polygon is convex when its chain goes once around the boundary of its hull and never back; strictly, when
// every vertex is also a corner.  What lies on one line is degenerate, not convex.  (2) The start of the chain changes
// nothing; reversing it flips the orientation alone.  (3) In space a polygon must be exactly planar; it is seen from
// the side of coplanar_orientation.  (4) A surface is convex when it bounds a convex solid, faces counterclockwise from
// outside; faces in one plane and corners on straight edges are allowed.
// Method: a chain that turns to one side alone goes around as often as it changes, half, between going up and down in
// the lexicographic order.  A closed surface of convex faces that all face away from one point, winds once around the
// line from there to each vertex, and bends outward at no ridge is convex (a covering of the sphere without branches is
// one to one): so an extruded pentagram is refused, capped in whatever way.
// Fewer than three vertices, and indices out of range, throw InvalidShape; NaN and infinity NonFinite.
// Source: RTCD 3.7.1, 3.8.1; Mehlhorn et al., Checking geometric programs, 1999.
// Cost: linear in the corners.  Bounded by n signs, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <string>

#include "plumb/arith/sign.hpp"
#include "plumb/figure/basic/mesh.hpp"
#include "plumb/figure/basic/polygon.hpp"

namespace plumb {

enum class QuadrilateralKind : unsigned char {
  convex,           // the diagonals cross, each inside the other
  concave,          // a dart: one corner in the triangle of the others
  bowtie,           // two edges cross
  three_collinear,  // three corners, but not all, lie on a line: a triangle with a fourth corner, a flag, a fold
  degenerate,       // all on one line, or at one point
  not_planar,
};

QuadrilateralKind quadrilateral_kind(const Quadrilateral2& quadrilateral);
QuadrilateralKind quadrilateral_kind(const Quadrilateral3& quadrilateral);

bool is_convex(const Quadrilateral2& quadrilateral);
bool is_convex(const Quadrilateral3& quadrilateral);

/// Does each diagonal part the other two corners?  In a plane this is convexity; of corners that are not in a plane it
/// says that the folds along the diagonals are by less than a right angle.
bool diagonals_part(const Quadrilateral3& quadrilateral);

enum class PolygonKind : unsigned char {
  strictly_convex,
  convex,        // with repeated vertices or vertices on straight edges
  concave,       // turns to both sides, or goes back the way it came
  self_winding,  // turns to one side alone, but goes around more than once: the pentagram
  degenerate,    // all on one line, or at one point
  not_planar,
};

struct PolygonConvexity {
  PolygonKind kind;
  Sign
      orientation;  // the side to which it turns, positive to the left; where it turns to both, that of its signed area
  int turns;        // how often it goes around, where it turns to one side alone; else 0

  [[nodiscard]] bool is_convex() const { return kind <= PolygonKind::convex; }
  friend bool operator==(const PolygonConvexity&, const PolygonConvexity&) = default;
};

PolygonConvexity convexity(const Polygon2& polygon);
PolygonConvexity convexity(const Polygon3& polygon);

bool is_convex(const Polygon2& polygon);
bool is_convex(const Polygon3& polygon);

/// Do all vertices lie in one plane, exactly?
bool is_planar(const Quadrilateral3& quadrilateral);
bool is_planar(const Polygon3& polygon);

/// The sign of the signed area, exactly.
Sign orientation(const Polygon2& polygon);

enum class SurfaceFlaw : unsigned char {
  none,
  no_volume,         // all vertices lie in one plane
  unused_vertex,     // `vertex` belongs to no face
  face_not_planar,   // `face`: its corner `vertex` is off the plane of others
  face_not_convex,   // `face`
  open_edge,         // the edge from `vertex` to `other_vertex` of `face` has not just one face across, running back
  several_pieces,    // `face` and `other_face` are not joined by edges
  inside_out,        // all faces are clockwise seen from outside
  concave_ridge,     // between `face` and `other_face`, along the edge from `vertex` to `other_vertex`
  seen_from_behind,  // `face` has `vertex` above it, though every ridge is convex
  winds_twice,       // the faces around `vertex` go around it more than once
};

struct SurfaceConvexity {
  SurfaceFlaw flaw = SurfaceFlaw::none;
  std::uint32_t face = 0, other_face = 0, vertex = 0, other_vertex = 0;  // where the flaw names them
  bool strictly = false;  // convex, every ridge bends and every corner is one

  [[nodiscard]] bool is_convex() const { return flaw == SurfaceFlaw::none; }
};

/// The first flaw, in the order of SurfaceFlaw.
SurfaceConvexity convexity(const PolygonMesh& mesh);
SurfaceConvexity convexity(const TriangleMesh& mesh);

bool is_convex(const PolygonMesh& mesh);
bool is_convex(const TriangleMesh& mesh);

/// What is wrong and wanted, as a sentence: "face 3 is not planar: vertex 7 is off its plane".  Empty for no flaw.
std::string describe(const SurfaceConvexity& convexity);

}  // namespace plumb
