// What is a mesh?  Vertices, and faces that name them; nothing is assumed of the shape.
//
// Laws: an index is always in range; anything else a file from the wild holds is allowed: repeated vertices, faces of
// zero area, edges with one face or five.  Coordinates are the doubles of the file, unchanged.
// Source: RTCD 2.2.1, 12.
// Cost: none.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/arith/point.hpp"

namespace plumb {

struct TriangleMesh {
  /// The vertices of a face, counterclockwise seen from outside, where the mesh has an outside.
  using Triangle = std::array<std::uint32_t, 3>;
  std::vector<Point3> vertices;
  std::vector<Triangle> triangles;
};

/// Faces of any number of corners (at least 3), corners of face f in corners[first[f]] up to corners[first[f + 1]].
struct PolygonMesh {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> first{0};
};

}  // namespace plumb
