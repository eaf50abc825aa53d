#include "plumb/surface/solid/exact_mesh.hpp"

namespace plumb {

Rational exact_volume(const ExactMesh& mesh) {
  std::vector<RationalPoint3> at;
  at.reserve(mesh.vertices.size());
  for (const ExactPoint3& p : mesh.vertices) at.push_back(rational_point(p));
  Rational six_fold;
  for (const auto& [i, k, l] : mesh.triangles) {
    const RationalPoint3 &a = at[i], &b = at[k], &c = at[l];
    six_fold = six_fold + a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
  }
  return six_fold / Rational(6);
}

}  // namespace plumb
