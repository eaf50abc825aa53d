// Plane section, slicing: where does a plane cut a mesh?  Closed contours with exact corners, which turns which way,
// and which lies in which.
//
//   const Section cut = section(mesh, Plane3{{0, 0, 1}, 1.5});       // z = 1.5
//   for (const Contour& c : cut.contours) draw(c.corners);           // corner.nearest: the nearest doubles
//   orient3d(exact_corner(mesh, cut.plane, corner), p, q, r);        // decided about the corner itself
//
// A vertex in the plane counts as above it, on the side of the normal (OnPlane::above), so that a triangle is cut or
// not, and what is cut closes: the section is what a plane an infinitesimal step below would cut, moved up by that
// step.
// The top of a box at its height is a contour, its bottom none; with OnPlane::below it is the other way round.
// Laws: (1) connected by signs alone; a corner is where an edge meets the plane, as two vertices of the mesh, or one of
// its vertices.  (2) Seen from the normal's side, the solid lies to the left: outer contours turn counterclockwise,
// holes clockwise, where the mesh's triangles turn counterclockwise seen from outside.  (3) The winding number of the
// contours about a point of the plane that is on no triangle but those in the plane is that of the mesh about the point
// moved by the infinitesimal step, if the mesh is closed (is_oriented_closed).  (4) Corners that are the same point are
// one corner, whichever edges they are from; segments that run both ways between the same corners cancel: two solids
// that share a wall are one.  (5) A contour passes each of its corners once: where more than two segments meet,
// contours touch, and cross only where the segments do.  (6) The order of the triangles changes nothing but that of
// coplanar_triangles.
// What is left of a mesh that is not closed, or whose triangles are wound against each other, are open chains.
// Contours that cross each other, of a surface that crosses itself, are told as they are: law 3 holds, and one lies in
// another when its box does, seen along the normal's largest coordinate, and its first corner off the other.
// A triangle that names no vertex and a plane without a normal throw InvalidShape, NaN and infinity NonFinite.
// Source: RTCD 8.3.4 (thick planes aside); Minetto et al. 2017 for many planes.
// Cost: linear in the triangles, and below a microsecond for each that is cut; nesting n log n in the corners, and
// below a microsecond for each pair of contours whose boxes lie in each other.  Many planes of one normal look at each
// vertex once, and at each triangle where they reach it; planes are shared out among threads.  Bounded by n^2
// operations for the nesting, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/arith/sign.hpp"
#include "plumb/figure/basic/mesh.hpp"
#include "plumb/query/section/planes.hpp"

namespace plumb {

/// On which side vertices in the plane count.
enum class OnPlane : unsigned char { above, below };

/// Where the edge from a vertex below to one above meets the plane; a vertex in the plane, where the two are equal.
struct SectionCorner {
  std::uint32_t below, above;
  Point3 nearest;  // the nearest doubles
  friend bool operator==(const SectionCorner&, const SectionCorner&) = default;
};

struct Contour {
  std::vector<SectionCorner> corners;   // each once; of a closed one the last is joined to the first
  bool closed = true;                   // else a chain, which lies in none, and none in it
  Sign turn = Sign::zero;               // counterclockwise seen from the normal's side: positive; zero: no area
  std::optional<std::uint32_t> parent;  // the contour around it
  std::uint32_t depth = 0;              // how many lie around it
};

struct Section {
  AnyPlane3 plane;
  OnPlane on_plane = OnPlane::above;
  std::vector<Contour> contours;
  std::vector<std::uint32_t> coplanar_triangles;  // wholly in the plane, those without area included
  std::uint64_t cut_triangles = 0;
  std::uint64_t corners_on_vertices = 0;  // corners that are vertices of the mesh
  std::uint64_t touching_corners = 0;     // corners in which contours touch each other, or themselves before law 5
  std::uint64_t canceled_segments = 0;    // pairs that run both ways
};

Section section(const TriangleMesh& mesh, const AnyPlane3& plane, OnPlane on_plane = OnPlane::above);

/// One for each plane, in their order.
std::vector<Section> sections(const TriangleMesh& mesh, std::span<const AnyPlane3> planes,
                              OnPlane on_plane = OnPlane::above);

/// The corner itself, of a section of this mesh by this plane.
ExactPoint3 exact_corner(const TriangleMesh& mesh, const AnyPlane3& plane, const SectionCorner& corner);

}  // namespace plumb
