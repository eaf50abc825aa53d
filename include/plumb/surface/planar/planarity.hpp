// Is this polygon planar, and if not, how far is it from it?
//
//   for (const BentFace& f : bent_faces(mesh)) print(f.face, f.width.width);      // or those thicker than a length
//   triangulate_planar(mesh, 1e-6)                       // refuses those that are thicker
//
// Laws: (1) the thickness of a polygon is the least width of its corners (figure/measures/width.hpp), exactly; it is
// compared with the length exactly, and equal is thin enough.  (2) Newell's normal is twice the polygon's vector area,
// each coordinate the exact value rounded to nearest; for a planar polygon it is normal to its plane, up to that.  It is
// zero for a polygon whose area cancels.
// A length that is NaN or infinite throws NonFinite, a negative one InvalidShape; so do meshes that are none.
// Source: RTCD 12.4, 12.5.1; Newell's method: Sutherland, Sproull and Schumacker 1974.
// Cost: linear for triangles and polygons that are planar; else that of least_width.  Bounded by n^3 signs for a face of
// n corners, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/figure/measures/width.hpp"

namespace plumb {

struct BentFace {
  std::uint32_t face;
  PointsWidth width;  // its points are numbers of corners of the face
};

/// Faces that are thicker than the length, ascending: with length 0 all that are not exactly planar.
std::vector<BentFace> bent_faces(const PolygonMesh& mesh, double length = 0);

Vector3 newell_normal(std::span<const Point3> polygon);

/// triangulate(mesh), where no face is thicker than the length; else InvalidShape is thrown, which names the first.
TriangleMesh triangulate_planar(const PolygonMesh& mesh, double length = 0);

}  // namespace plumb
