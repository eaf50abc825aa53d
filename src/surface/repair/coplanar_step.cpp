#include "plumb/surface/repair/merge_coplanar.hpp"
#include "surface/repair/steps.hpp"

namespace plumb::surface {

void coplanar_step(RepairWork& work) {
  const CoplanarFaces faces =
      merge_coplanar(work.mesh, {.tolerance = work.step.tolerance, .collinear = work.step.collinear});
  for (const std::uint32_t t : faces.apart) work.note(ChangeKind::kept_coplanar, work.mesh.triangles[t][0]);
  TriangleMesh fewer = triangulated(work.mesh, faces);
  if (fewer.triangles.size() == work.mesh.triangles.size()) return;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const auto before = faces.triangles_of(f);
    if (before.size() > faces.fewest_triangles(f))
      work.note(ChangeKind::merged_coplanar, faces.corners[faces.first_corner[faces.first_ring[f]]], before.size());
  }
  work.mesh.triangles = std::move(fewer.triangles);
}

}  // namespace plumb::surface
