#include "tool/mesh/bent_faces.hpp"

#include <algorithm>
#include <span>

#include "plumb/certify/direction.hpp"
#include "plumb/predicates.hpp"

namespace plumb::tool {
namespace {

bool is_bent(const PolygonMesh& mesh, std::span<const std::uint32_t> corners) {
  const auto at = [&](std::size_t k) -> const Point3& { return mesh.vertices[corners[k]]; };
  // A triangle of the face that spans its plane; there is none where all corners are on one line.
  std::size_t b = 1;
  while (b < corners.size() && at(b) == at(0)) ++b;
  std::size_t c = b + 1;
  while (c < corners.size() && collinear(at(0), at(b), at(c))) ++c;
  for (std::size_t d = c + 1; d < corners.size(); ++d)
    if (orient3d(at(0), at(b), at(c), at(d)) != Sign::zero) return true;
  return false;
}

}  // namespace

std::uint64_t bent_faces(const PolygonMesh& mesh) {
  std::uint64_t bent = 0;
  const std::span<const std::uint32_t> corners(mesh.corners);
  for (std::size_t f = 0; f + 1 < mesh.first.size(); ++f) {
    const std::size_t size = mesh.first[f + 1] - mesh.first[f];
    bent += size > 3 && is_bent(mesh, corners.subspan(mesh.first[f], size));
  }
  return bent;
}

}  // namespace plumb::tool
