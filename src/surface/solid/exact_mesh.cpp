#include "plumb/surface/solid/exact_mesh.hpp"

#include <span>

namespace plumb {
namespace {

Rational six_fold_volume(const std::vector<RationalPoint3>& at, std::span<const TriangleMesh::Triangle> triangles) {
  if (triangles.empty()) return 0;
  if (triangles.size() == 1) {
    const auto& [i, k, l] = triangles[0];
    const RationalPoint3 &a = at[i], &b = at[k], &c = at[l];
    return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
  }
  // Halves are summed, so that few sums have the denominators of many.
  const std::size_t half = triangles.size() / 2;
  return six_fold_volume(at, triangles.first(half)) + six_fold_volume(at, triangles.subspan(half));
}

}  // namespace

Rational exact_volume(const ExactMesh& mesh) {
  std::vector<RationalPoint3> at;
  at.reserve(mesh.vertices.size());
  for (const ExactPoint3& p : mesh.vertices) at.push_back(rational_point(p));
  return six_fold_volume(at, mesh.triangles) / Rational(6);
}

}  // namespace plumb
