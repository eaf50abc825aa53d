// Exact mesh: a surface whose vertices are exact points, and which triangle of which mesh each face is a piece of.
//
// Laws: (1) vertices ascend lexicographically, no two equal; one that doubles hold is held as Point3, any other in
// rational coordinates: so equal meshes are told alike.  (2) Triangles begin with their smallest vertex and ascend.
// (3) exact_volume is that of the solid where the mesh is closed and wound outward, negative where wound inward.
// Source: RTCD 2.2.1.
// Cost: a volume takes some microseconds a triangle, and more where many vertices are no doubles: its denominator is
// that of all of them.  Nothing is searched.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "plumb/arith/rational.hpp"
#include "plumb/certify/exact_point.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb {

/// A triangle of one of the meshes that were given, by their numbers.
struct SourceFace {
  std::uint32_t mesh, triangle;
  friend auto operator<=>(const SourceFace&, const SourceFace&) = default;
};

struct ExactMesh {
  std::vector<ExactPoint3> vertices;
  std::vector<TriangleMesh::Triangle> triangles;
  std::vector<SourceFace> sources;  // of each triangle
};

Rational exact_volume(const ExactMesh& mesh);

}  // namespace plumb
